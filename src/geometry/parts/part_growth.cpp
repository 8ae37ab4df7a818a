// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface area heuristic of ray tracing, with surface in place of the number of triangles: how
// finely a mesh is cut into triangles says nothing about where it should be split.
#include "geometry/parts/part_growth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace link_bounds {
namespace {

constexpr std::size_t kBins = 32;

/// Items taken together.
struct Gathering {
  Eigen::AlignedBox3f box;
  double surface = 0;

  void add(const PartItem& item) {
    box.extend(item.low).extend(item.high);
    surface += static_cast<double>(item.surface);
  }
  void add(const Gathering& other) {
    box.extend(other.box);
    surface += other.surface;
  }
  bool isEmpty() const { return box.isEmpty(); }
  double cost() const {
    const Eigen::Vector3d width = box.sizes().cast<double>();
    return (width.x() * width.y() + width.y() * width.z() + width.z() * width.x()) * surface;
  }
};

/// Of the items' centres along one axis.
struct BinScale {
  int axis;
  float low;
  float bins_per_unit;

  std::size_t binOf(const PartItem& item) const {
    const float place = (item.center()[axis] - low) * bins_per_unit;
    return std::min(static_cast<std::size_t>(place), kBins - 1);
  }
};

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  BinScale scale{};
  std::size_t first_bin_of_right = 0;
};

using Bins = std::array<Gathering, kBins>;

void tryBorders(const Bins& bins, const BinScale& scale, Split& best) {
  std::array<Gathering, kBins + 1> from;
  for (std::size_t i = kBins; i-- > 0;) {
    from[i] = from[i + 1];
    from[i].add(bins[i]);
  }
  Gathering before;
  for (std::size_t i = 1; i < kBins; ++i) {
    before.add(bins[i - 1]);
    if (before.isEmpty() || from[i].isEmpty()) continue;
    const double cost = before.cost() + from[i].cost();
    if (cost < best.cost) best = {cost, scale, i};
  }
}

std::vector<BinScale> binScales(const PartItems& items, const PartNode& node) {
  Eigen::AlignedBox3f centers;
  for (std::size_t i = node.begin; i < node.end; ++i)
    centers.extend(items[i].center());
  std::vector<BinScale> scales;
  for (int axis = 0; axis < 3; ++axis) {
    const float bins_per_unit = static_cast<float>(kBins) / centers.sizes()[axis];
    if (std::isfinite(bins_per_unit)) scales.push_back({axis, centers.min()[axis], bins_per_unit});
  }
  return scales;
}

Split bestSplit(const PartItems& items, const PartNode& node) {
  const std::vector<BinScale> scales = binScales(items, node);
  std::array<Bins, 3> bins;
  for (std::size_t i = node.begin; i < node.end; ++i) {
    for (const BinScale& scale : scales)
      bins[static_cast<std::size_t>(scale.axis)][scale.binOf(items[i])].add(items[i]);
  }
  Split best;
  for (const BinScale& scale : scales)
    tryBorders(bins[static_cast<std::size_t>(scale.axis)], scale, best);
  return best;
}

/// True if there are two children now.
bool splitNode(PartItems& items, std::vector<PartNode>& nodes, std::size_t index) {
  const PartNode node = nodes[index];
  const Split split = bestSplit(items, node);
  if (split.first_bin_of_right == 0) return false;
  const auto begin = items.begin();
  const auto middle =
      std::partition(begin + static_cast<std::ptrdiff_t>(node.begin),
                     begin + static_cast<std::ptrdiff_t>(node.end), [&split](const PartItem& item) {
                       return split.scale.binOf(item) < split.first_bin_of_right;
                     });
  const auto border = static_cast<std::size_t>(middle - begin);
  nodes[index].left = nodes.size();
  nodes.push_back({node.begin, border});
  nodes[index].right = nodes.size();
  nodes.push_back({border, node.end});
  return true;
}

double costOf(const PartItems& items, const PartNode& node) {
  Gathering all;
  for (std::size_t i = node.begin; i < node.end; ++i)
    all.add(items[i]);
  return all.cost();
}

}  // namespace

std::vector<PartNode> growTree(PartItems& items, std::size_t most_leaves) {
  std::vector<PartNode> nodes{{0, items.size()}};
  std::priority_queue<std::pair<double, std::size_t>> leaves;
  leaves.emplace(costOf(items, nodes[0]), 0);
  for (std::size_t count = 1; count < most_leaves && !leaves.empty();) {
    const std::size_t index = leaves.top().second;
    leaves.pop();
    if (!splitNode(items, nodes, index)) continue;
    ++count;
    for (const std::size_t child : {nodes[index].left, nodes[index].right})
      leaves.emplace(costOf(items, nodes[child]), child);
  }
  return nodes;
}

}  // namespace link_bounds
