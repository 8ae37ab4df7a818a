// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sequences of poses, faults among them, in batches: each box must be, bit by bit, that of a
// computation without memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

#include "geometry/support/table/direction_table.h"
#include "link_bounds/geometry/shape/link_boxes.h"
#include "testing/brute_force.h"
#include "testing/numbers.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr int kSequences = kIsSanitized ? 2'000 : 100'000;  // of each kind of shape
constexpr int kSequenceSteps = 5;
constexpr int kMaxLinks = 40;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

int below(int count, Random& random) {
  return static_cast<int>(random.uniform(0, count));
}

/// What a pose should not contain but may.
double oddNumber(Random& random) {
  constexpr double kOdd[] = {kNaN, kInfinity, -kInfinity, 2e30, -1e300, 1e-310};
  return kOdd[below(6, random)];
}

/// The next pose after `pose`; `first` is an earlier one of the sequence.
Eigen::Affine3d nextPose(const Eigen::Affine3d& pose, const Eigen::Affine3d& first,
                         Random& random) {
  Eigen::Affine3d next = pose;
  switch (below(12, random)) {
    case 0:
    case 1:
      return random.rigid(1);
    case 2:
      return pose;
    case 3:
      return first;
    case 4:
      next.linear() = first.linear();
      return next;
    case 5:
      next.translation() = random.vector(10);
      return next;
    case 6:  // one row changes, the others stay
      next.linear().row(below(3, random)) = random.vector(1).transpose();
      return next;
    case 7:  // one row stays
      next.linear() = brute_force::turned(random.uniform(0, 360), Eigen::Vector3d::UnitZ());
      return next;
    case 8:  // mirrored
      next.linear().row(below(3, random)) *= -1;
      return next;
    case 9:
      next.linear()(below(3, random), below(3, random)) = oddNumber(random);
      return next;
    case 10:
      next.translation()[below(3, random)] = oddNumber(random);
      return next;
    default:  // turned, and out of reach
      next = random.rigid(1);
      next.translation()[below(3, random)] = oddNumber(random);
      return next;
  }
}

/// False of boxes that are not finite, because there must be none.
bool isSame(const std::optional<Aabb>& a, const std::optional<Aabb>& b) {
  if (!a || !b) return !a && !b;
  if (!a->min().allFinite() || !a->max().allFinite()) return false;
  return std::memcmp(a->min().data(), b->min().data(), sizeof(double[3])) == 0 &&
         std::memcmp(a->max().data(), b->max().data(), sizeof(double[3])) == 0;
}

using ShapeMaker = std::function<Shape(Random&)>;

/// Links of one to five shapes of a kind, some of which lie in the frame of the link.
std::vector<BoundedLink> linksOf(const ShapeMaker& make_shape, Random& random) {
  std::vector<BoundedLink> links(kMaxLinks);
  for (BoundedLink& link : links) {
    const int count = 1 + below(5, random);
    for (int i = 0; i < count; ++i) {
      link.shapes.push_back(make_shape(random));
      if (below(3, random) == 0) link.shapes.back().link_from_shape = random.affine(1);
    }
    if (below(4, random) == 0) link.padding = 0.1;
  }
  return links;
}

/// Of one sequence: links that move, and their boxes.
class Batch {
 public:
  /// Mostly few links, so that there is time for many sequences.
  Batch(const std::vector<BoundedLink>& links, Random& random) {
    const int size = below(20, random) == 0 ? 1 + below(kMaxLinks, random) : 1 + below(4, random);
    for (int i = 0; i < size; ++i) {
      links_.push_back(links[static_cast<std::size_t>(below(kMaxLinks, random))]);
      first_.push_back(random.rigid(1));
    }
    poses_ = first_;
    boxes_ = LinkBoxes(links_);
    for (std::size_t i = 0; i < poses_.size(); ++i)
      moved_.push_back({i, &poses_[i]});
    boxes_.update(moved_);
  }

  /// The poses that moved_ points to.
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  /// Most links move, some of them twice, all at once or one by one.
  void move(Random& random) {
    moved_.clear();
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (below(10, random) == 0) continue;
      poses_[i] = nextPose(poses_[i], first_[i], random);
      if (below(20, random) == 0) moved_.push_back({i, &first_[i]});
      moved_.push_back({i, &poses_[i]});
    }
    if (below(8, random) != 0) return boxes_.update(moved_);
    for (const auto& [link, pose] : moved_)
      boxes_.update(link, *pose);
  }

  /// The number of boxes that differ from those without memory.
  int wrongBoxes() const {
    int wrong = 0;
    for (std::size_t i = 0; i < links_.size(); ++i)
      wrong += isSame(boxes_.box(i), linkBox(links_[i], poses_[i])) ? 0 : 1;
    return wrong;
  }

 private:
  std::vector<BoundedLink> links_;
  std::vector<Eigen::Affine3d> first_, poses_;
  std::vector<MovedLink> moved_;
  LinkBoxes boxes_;
};

void checkSequences(const ShapeMaker& make_shape) {
  Random random(14);
  const std::vector<BoundedLink> links = linksOf(make_shape, random);
  int wrong = 0;
  int wrong_sequences = 0;
  for (int i = 0; i < kSequences; ++i) {
    Batch batch(links, random);
    int wrong_here = batch.wrongBoxes();
    for (int step = 1; step < kSequenceSteps; ++step) {
      batch.move(random);
      wrong_here += batch.wrongBoxes();
    }
    wrong += wrong_here;
    wrong_sequences += wrong_here > 0 ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << "boxes in " << wrong_sequences << " of " << kSequences << " sequences";
}

std::shared_ptr<const PointSet> pointsInFloat(std::size_t count, Random& random) {
  return std::make_shared<const PointSet>(random.points(count, 0.5));
}

std::shared_ptr<const PointSet> pointsInDouble(std::size_t count, Random& random) {
  const std::shared_ptr<double> xyz(new double[3 * count], std::default_delete<double[]>());
  std::generate_n(xyz.get(), 3 * count, [&] { return random.uniform(-1, 1); });
  return std::make_shared<const PointSet>(xyz, count);
}

/// Several links share a mesh of each size.
ShapeMaker sharedMeshes(std::size_t points, Solid solid = Solid::kNone) {
  Random random(15);
  std::vector<std::shared_ptr<const PointSet>> meshes;
  for (int i = 0; i < 6; ++i)
    meshes.push_back(pointsInFloat(points, random));
  const Eigen::Vector3d size =
      solid == Solid::kNone ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(0.1, 0.2, 0.3);
  return [=](Random& chooser) {
    return Shape{meshes[static_cast<std::size_t>(below(6, chooser))], solid, size,
                 Eigen::Affine3d::Identity()};
  };
}

ShapeMaker scans() {
  return [](Random& random) {
    return Shape{pointsInDouble(5, random), Solid::kNone, {0, 0, 0}, Eigen::Affine3d::Identity()};
  };
}

ShapeMaker solids(Solid solid) {
  return [=](Random& random) {
    return Shape{nullptr, solid, random.vector(1).cwiseAbs(), Eigen::Affine3d::Identity()};
  };
}

ShapeMaker oneOf(const std::vector<ShapeMaker>& makers) {
  return [=](Random& random) {
    return makers[static_cast<std::size_t>(below(static_cast<int>(makers.size()), random))](random);
  };
}

TEST(LinkBoxesSequences, OfMeshesOfFewPoints) {
  checkSequences(sharedMeshes(kScannedPoints));
}

TEST(LinkBoxesSequences, OfMeshesWithATable) {
  checkSequences(sharedMeshes(100));
}

TEST(LinkBoxesSequences, OfPointsInDouble) {
  checkSequences(scans());
}

TEST(LinkBoxesSequences, OfSolids) {
  checkSequences(oneOf({solids(Solid::kBox), solids(Solid::kEllipsoid), solids(Solid::kCylinder)}));
}

TEST(LinkBoxesSequences, OfMeshesSweptBySolids) {
  checkSequences(oneOf({sharedMeshes(30, Solid::kBox), sharedMeshes(30, Solid::kCylinder)}));
}

TEST(LinkBoxesSequences, OfShapesOfEveryKind) {
  checkSequences(oneOf({sharedMeshes(10), sharedMeshes(100), sharedMeshes(30, Solid::kEllipsoid),
                        scans(), solids(Solid::kBox), solids(Solid::kCylinder)}));
}

}  // namespace
}  // namespace link_bounds
