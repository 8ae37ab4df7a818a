// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Labels are placed one by one, from the lowest upward.
#include "node/outputs/markers/label_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "node/outputs/markers/drawable.h"

namespace link_bounds {
namespace {

constexpr double kHeight = 0.05;            ///< text height for a box with a diagonal of 1 m [m]
constexpr double kMinHeight = 1e-3;         ///< [m]
constexpr double kCharacterWidth = 0.6;     ///< per height; the mean of rviz's font is about 0.5
constexpr std::size_t kMaxNeighbours = 64;  ///< only the highest so far count, to limit the time

double top(const Label& label) {
  return label.bottom.z() + label.height;
}

bool overlap(const Label& a, const Label& b) {
  const double width = (a.width + b.width) / 2;
  return std::abs(a.bottom.x() - b.bottom.x()) < width &&
         std::abs(a.bottom.y() - b.bottom.y()) < width && a.bottom.z() < top(b) &&
         b.bottom.z() < top(a);
}

/// The loop ends because each move raises the label. `neighbours` are sorted by their bottoms, so
/// two rounds nearly always suffice.
void putOnTop(const std::vector<Label>& neighbours, Label& label) {
  for (bool is_moved = true; is_moved;) {
    is_moved = false;
    for (const Label& neighbour : neighbours) {
      if (!overlap(label, neighbour)) continue;
      label.bottom << neighbour.bottom.head<2>(), top(neighbour);
      is_moved = true;
    }
  }
}

}  // namespace

std_msgs::ColorRGBA labelColor() {
  return toColor({0.85, 0.2, 0.55, 1});
}

/// The square root keeps small boxes readable beside large ones.
Label labelOf(const Aabb& box, const std::string& text) {
  const double diagonal = (box.max() - box.min()).norm();
  const double widths = kCharacterWidth * std::max(1.0, static_cast<double>(text.size()));
  const double height =
      std::max(kMinHeight, std::min(kHeight * std::sqrt(diagonal), diagonal / widths));
  return {box.max() + Eigen::Vector3d(0, 0, 0.25 * height), widths * height, height};
}

void separate(std::vector<Label>& labels) {
  const auto is_lower = [](const Label& a, const Label& b) { return a.bottom.z() < b.bottom.z(); };
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return is_lower(labels[a], labels[b]); });
  std::vector<Label> neighbours;
  for (const std::size_t i : order) {
    putOnTop(neighbours, labels[i]);
    if (neighbours.size() == kMaxNeighbours) neighbours.erase(neighbours.begin());
    neighbours.insert(std::upper_bound(neighbours.begin(), neighbours.end(), labels[i], is_lower),
                      labels[i]);
  }
}

}  // namespace link_bounds
