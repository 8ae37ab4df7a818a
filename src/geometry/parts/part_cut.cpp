// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the best cut through the tree for each number of parts, from the leaves up. Always
// splitting the part that gains most would stop too early: half a hollow ball needs as much room as
// half a solid one, so only the second split gains anything.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/parts/part_tree.h"

namespace link_bounds {
namespace {

constexpr std::size_t kLooksPerVolume = 10;  ///< cost of a volume, see WorkMeter
constexpr double kMinGain = 1e-9;            ///< of a volume; less is rounding

/// A link moves. Parts that are tight only in the axes of the link would help little once it is
/// turned, so their boxes are measured along several sets of axes.
constexpr int kAxisSets = 8;
using AxisSets = std::array<Eigen::Matrix3d, kAxisSets>;
using Coordinates = Eigen::Array<double, 3 * kAxisSets, 1>;

Eigen::Matrix3d turned(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// First the axes of the link; then turned by 45 degrees about these, and by 60 about diagonals.
AxisSets axisSets() {
  return {Eigen::Matrix3d::Identity(),  turned(M_PI / 4, {1, 0, 0}), turned(M_PI / 4, {0, 1, 0}),
          turned(M_PI / 4, {0, 0, 1}),  turned(M_PI / 3, {1, 1, 1}), turned(M_PI / 3, {-1, 1, 1}),
          turned(M_PI / 3, {1, -1, 1}), turned(M_PI / 3, {1, 1, -1})};
}

/// The boxes of some items along each set of axes.
struct TurnedBoxes {
  Coordinates min = Coordinates::Constant(std::numeric_limits<double>::infinity());
  Coordinates max = -min;

  void extend(const Coordinates& low, const Coordinates& high) {
    min = min.min(low);
    max = max.max(high);
  }

  double volume(int axis_set) const { return (max - min).segment<3>(3 * axis_set).prod(); }
};

/// The volumes of a node's boxes, in the units of the tree.
struct NodeVolumes {
  double at_rest;   ///< in the axes of the link
  double weighted;  ///< half at_rest, half the mean of those in turned axes
};

NodeVolumes volumesOf(const TurnedBoxes& boxes) {
  double turned_sum = 0;
  for (int i = 1; i < kAxisSets; ++i)
    turned_sum += boxes.volume(i);
  const double at_rest = boxes.volume(0);
  return {at_rest, (at_rest + turned_sum / (kAxisSets - 1)) / 2};
}

/// Maps the points of one shape to coordinates along all axes.
class TurnedShape {
 public:
  TurnedShape(const AxisSets& axis_sets, const Eigen::Affine3d& unit_from_shape) {
    for (int i = 0; i < kAxisSets; ++i) {
      const Eigen::Matrix3d& axes = axis_sets[static_cast<std::size_t>(i)];
      linear_.middleRows<3>(3 * i) = axes * unit_from_shape.linear();
      translation_.segment<3>(3 * i) = (axes * unit_from_shape.translation()).array();
    }
  }

  Coordinates operator*(const Eigen::Vector3f& point) const {
    return (linear_ * point.cast<double>()).array() + translation_;
  }

 private:
  Eigen::Matrix<double, 3 * kAxisSets, 3> linear_;
  Coordinates translation_;
};

void extendByShape(const AxisSets& axis_sets, const Shape& shape,
                   const Eigen::Affine3d& unit_from_link, TurnedBoxes& boxes) {
  Coordinates low;
  Coordinates high;
  for (int i = 0; i < kAxisSets; ++i) {
    const Eigen::Matrix3d& axes = axis_sets[static_cast<std::size_t>(i)];
    const Aabb box = worldBox(shape, axes * unit_from_link).value();
    low.segment<3>(3 * i) = box.min().array();
    high.segment<3>(3 * i) = box.max().array();
  }
  boxes.extend(low, high);
}

/// The volumes of each node: of leaves from their items, of others from their children's.
std::vector<NodeVolumes> nodeVolumes(const PartTree& tree,
                                     const std::vector<DivisibleShape>& shapes,
                                     const Eigen::Affine3d& unit_from_link, WorkMeter& meter) {
  const AxisSets axis_sets = axisSets();
  std::vector<TurnedShape> turned_shapes;
  for (const DivisibleShape& shape : shapes)
    turned_shapes.emplace_back(axis_sets, unit_from_link * shape.shape.link_from_shape);
  const auto extend = [&](const PartItem& item, TurnedBoxes& boxes) {
    const DivisibleShape& shape = shapes[item.shape];
    if (!shape.mesh) return extendByShape(axis_sets, shape.shape, unit_from_link, boxes);
    for (const std::uint32_t vertex : shape.mesh->triangles[item.triangle]) {
      const Coordinates point = turned_shapes[item.shape] * shape.mesh->vertices[vertex];
      boxes.extend(point, point);
    }
  };
  std::vector<TurnedBoxes> boxes(tree.nodes.size());
  std::vector<NodeVolumes> volumes(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const PartNode& node = tree.nodes[i];
    if (node.isLeaf()) {
      meter.add(kLooksPerVolume * (node.end - node.begin));
      for (std::size_t k = node.begin; k < node.end; ++k)
        extend(tree.items[k], boxes[i]);
    } else {
      boxes[i] = boxes[node.left];
      boxes[i].extend(boxes[node.right].min, boxes[node.right].max);
    }
    volumes[i] = volumesOf(boxes[i]);
  }
  return volumes;
}

/// The best cut through a subtree, by the number of parts that it may have at most.
struct Cuts {
  struct Choice {
    double volume;               ///< sum of the weighted volumes
    std::size_t left_parts = 0;  ///< how many parts the left child gets; 0: the node is one part
  };
  std::vector<Choice> choices;  ///< for 1, 2, ... parts

  const Choice& of(std::size_t parts) const { return choices[parts - 1]; }
  std::size_t maxParts() const { return choices.size(); }
};

Cuts cutsOf(double volume, const Cuts& left, const Cuts& right, std::size_t max_parts) {
  Cuts cuts;
  cuts.choices.resize(std::min(max_parts, left.maxParts() + right.maxParts()), {volume});
  for (std::size_t i = 1; i <= left.maxParts(); ++i) {
    for (std::size_t j = 1; j <= right.maxParts() && i + j <= cuts.maxParts(); ++j) {
      Cuts::Choice& choice = cuts.choices[i + j - 1];
      const double sum = left.of(i).volume + right.of(j).volume;
      if (sum < choice.volume * (1 - kMinGain)) choice = {sum, i};
    }
  }
  return cuts;
}

/// The cuts of the subtree below each node.
std::vector<Cuts> allCuts(const std::vector<PartNode>& nodes,
                          const std::vector<NodeVolumes>& volumes, std::size_t max_parts) {
  std::vector<Cuts> cuts(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].isLeaf()) {
      cuts[i].choices = {{volumes[i].weighted}};
    } else {
      cuts[i] = cutsOf(volumes[i].weighted, cuts[nodes[i].left], cuts[nodes[i].right], max_parts);
    }
  }
  return cuts;
}

/// The nodes of the best cut into so many parts.
std::vector<std::size_t> nodesOf(const std::vector<PartNode>& nodes, const std::vector<Cuts>& cuts,
                                 std::size_t parts) {
  std::vector<std::size_t> chosen;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, parts}};  // nodes and their parts
  while (!open.empty()) {
    const auto [index, share] = open.back();
    open.pop_back();
    const std::size_t left_parts = cuts[index].of(share).left_parts;
    if (left_parts == 0) {
      chosen.push_back(index);
    } else {
      open.emplace_back(nodes[index].right, share - left_parts);
      open.emplace_back(nodes[index].left, left_parts);
    }
  }
  return chosen;
}

double volumeAtRest(const std::vector<std::size_t>& chosen,
                    const std::vector<NodeVolumes>& volumes) {
  double sum = 0;
  for (const std::size_t index : chosen)
    sum += volumes[index].at_rest;
  return sum;
}

}  // namespace

std::vector<std::size_t> cutTree(const PartTree& tree, const std::vector<DivisibleShape>& shapes,
                                 const Eigen::Affine3d& unit_from_link, std::size_t max_parts,
                                 WorkMeter& meter) {
  const std::vector<NodeVolumes> volumes = nodeVolumes(tree, shapes, unit_from_link, meter);
  const std::vector<Cuts> cuts = allCuts(tree.nodes, volumes, max_parts);
  std::vector<std::size_t> best{0};
  for (std::size_t parts = 2; parts <= cuts[0].maxParts(); ++parts) {
    if (!(cuts[0].of(parts).volume < cuts[0].of(parts - 1).volume)) continue;
    std::vector<std::size_t> chosen = nodesOf(tree.nodes, cuts, parts);
    if (volumeAtRest(chosen, volumes) <= volumeAtRest(best, volumes)) best = std::move(chosen);
  }
  return best;
}

}  // namespace link_bounds
