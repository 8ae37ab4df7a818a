// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A binary tree over the triangles and indivisible shapes of a link, of which some nodes become
// parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "link_bounds/geometry/parts/link_parts.h"

namespace link_bounds {

/// A triangle or an indivisible shape. Lengths are in units of the link's longest side, so they fit
/// a float whatever the unit of the robot. They decide where to split, not how large a box is.
struct PartItem {
  Eigen::Vector3f min, max;  ///< of its box in the axes of the link
  float surface;             ///< of the triangle, or of the shape's box
  std::uint32_t shape;       ///< index
  std::uint32_t triangle;    ///< index in the shape's mesh

  Eigen::Vector3f center() const { return (min + max) / 2; }
};

/// Holds the items [begin, end). Those of an inner node are split between its two children.
struct PartNode {
  std::size_t begin;
  std::size_t end;
  std::size_t left = 0;  ///< index of a child; 0: the node is a leaf
  std::size_t right = 0;

  bool isLeaf() const { return left == 0; }
};

struct PartTree {
  std::vector<PartItem> items;
  std::vector<PartNode> nodes;  ///< the root first, parents before their children
};

/// The transform to the units of PartItem, with the min corner of the link's box at the origin.
/// Nothing if a shape has no finite box or all of the link is one point.
std::optional<Eigen::Affine3d> unitFromLink(const std::vector<DivisibleShape>& shapes);

PartTree growTree(const std::vector<DivisibleShape>& shapes, const Eigen::Affine3d& unit_from_link,
                  std::size_t max_leaves, WorkMeter& meter);

/// At most `max_parts` nodes that together hold each item once, such that their boxes are small in
/// the axes of the link and in turned axes. In the axes of the link the sum of their volumes is not
/// larger than for any smaller `max_parts`. Returns indices of nodes.
std::vector<std::size_t> cutTree(const PartTree& tree, const std::vector<DivisibleShape>& shapes,
                                 const Eigen::Affine3d& unit_from_link, std::size_t max_parts,
                                 WorkMeter& meter);

}  // namespace link_bounds
