// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels follow their boxes and are kept apart.
#include "node/outputs/markers/label_layout.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

Eigen::Vector3d middle(const Label& label) {
  return label.bottom + Eigen::Vector3d(0, 0, label.height / 2);
}

/// By how much two labels overlap along the axis on which they do least; negative: a gap [m].
double depth(const Label& a, const Label& b) {
  const double width = (a.width + b.width) / 2;
  const double height = (a.height + b.height) / 2;
  const Eigen::Vector3d gaps =
      (middle(a) - middle(b)).cwiseAbs() - Eigen::Vector3d(width, width, height);
  return -gaps.maxCoeff();
}

Aabb boxAt(const Eigen::Vector3d& min, double size) {
  return {min, min + Eigen::Vector3d::Constant(size)};
}

TEST(LabelLayout, ALabelStandsAboveItsBoxAndGrowsWithIt) {
  double last_height = 0;
  for (const double size : {0.001, 0.01, 0.1, 1.0, 10.0, 100.0}) {
    const Aabb box = boxAt({1, 2, 3}, size);
    const Label label = labelOf(box, "upper_arm");
    EXPECT_GT(label.bottom.z(), box.max().z());
    EXPECT_LT(label.bottom.z() - label.height, box.max().z());
    EXPECT_EQ(label.bottom.head<2>(), box.max().head<2>());
    EXPECT_GE(label.height, last_height);
    if (size >= 0.01) {
      EXPECT_LE(label.width, 1.001 * size * std::sqrt(3.0)) << size;
    }
    last_height = label.height;
  }
  EXPECT_GT(last_height, 0.3);
}

TEST(LabelLayout, ALongNameIsSmaller) {
  const Aabb box = boxAt({0, 0, 0}, 0.1);
  const Label label = labelOf(box, std::string(100, 'n'));
  EXPECT_LE(label.width, 0.1 * std::sqrt(3.0) + 1e-12);
  EXPECT_GT(labelOf(box, "n").height, 5 * label.height);
}

TEST(LabelLayout, LabelsOfABoxWithoutSizeHaveSome) {
  EXPECT_GT(labelOf(boxAt({0, 0, 0}, 0), "point").height, 0);
  EXPECT_GT(labelOf(boxAt({0, 0, 0}, 1), "").height, 0);
}

bool standsOnAnother(const std::vector<Label>& labels, std::size_t i) {
  return std::any_of(labels.begin(), labels.end(), [&](const Label& other) {
    return labels[i].bottom ==
           Eigen::Vector3d(other.bottom.x(), other.bottom.y(), other.bottom.z() + other.height);
  });
}

TEST(LabelLayout, NoTwoLabelsOverlapAndNoneSinks) {
  brute_force::Random random(1);
  for (int run = 0; run < 300; ++run) {
    std::vector<Label> labels;
    const int count = 2 + run % 60;
    for (int i = 0; i < count; ++i) {
      const double size = std::abs(random.magnitude(-2, 0));
      labels.push_back(labelOf(boxAt(random.vector(0.2), size),
                               std::string(1 + static_cast<std::size_t>(i) % 20, 'n')));
    }
    const std::vector<Label> before = labels;
    separate(labels);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      EXPECT_GE(labels[i].bottom.z(), before[i].bottom.z());
      if (labels[i].bottom != before[i].bottom) {
        EXPECT_TRUE(standsOnAnother(labels, i)) << run;
      }
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_LT(depth(labels[i], labels[k]), 1e-12) << run;
    }
  }
}

TEST(LabelLayout, LabelsThatAreApartStay) {
  std::vector<Label> labels{labelOf(boxAt({0, 0, 0}, 1), "a"), labelOf(boxAt({3, 0, 0}, 1), "b"),
                            labelOf(boxAt({0, 0, 2}, 1), "c")};
  const std::vector<Label> before = labels;
  separate(labels);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i].bottom, before[i].bottom);
}

}  // namespace
}  // namespace link_bounds
