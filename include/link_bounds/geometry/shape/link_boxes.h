// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// One link with everything on it that has a shape, and the box around all of it.
///
/// Metres; the box is in the frame whose axes it follows, the world. Nothing here throws.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/shape.h"

namespace link_bounds {

struct BoundedLink {
  std::string name;           ///< as in the URDF
  std::vector<Shape> shapes;  ///< what could be loaded; may be empty
  double padding = 0;         ///< added on every side of the box [m], >= 0
  std::string missing;        ///< why the shapes are not all of the link's geometry; "" = they are

  bool isWhole() const { return missing.empty(); }
};

/// The largest |coordinate| that computing with the link's shapes in its frame meets, which is at
/// least that of any of their points [m]; rounding errors are in proportion to it. Without padding.
double magnitude(const BoundedLink& link);

/// What linkBox keeps of one link from one update to the next; see ShapeReach.
struct LinkReach {
  explicit LinkReach(const BoundedLink& link) : shapes(link.shapes.begin(), link.shapes.end()) {}

  std::vector<ShapeReach> shapes;
};

/// The box around all shapes of the link, tight, rounded outward and padded. Nothing if the link
/// has no shape or the pose gives no finite box (see placedBox). `reach` must have been made for
/// this link.
std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link,
                            LinkReach& reach);

/// The same without memory.
std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link);

/// One link of many.
struct LinkUpdate {
  const BoundedLink* link = nullptr;
  const Eigen::Affine3d* world_from_link = nullptr;
  LinkReach* reach = nullptr;          ///< made for this link
  std::optional<Aabb>* box = nullptr;  ///< where the result of linkBox goes
};

/// Faster than a call per link: prefetches what the boxes read.
void updateLinkBoxes(const std::vector<LinkUpdate>& updates);

}  // namespace link_bounds
