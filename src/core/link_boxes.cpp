// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The union of the boxes of a link's shapes.
#include "link_bounds/link_boxes.h"

#include <algorithm>

#include "shape_steps.h"

namespace link_bounds {
namespace {

/// Links of which everything that is announced stays in the nearest cache.
constexpr std::ptrdiff_t kAtOnce = 16;

bool placeShape(const Shape& shape, const Eigen::Affine3d& world_from_link, ShapeReach& reach,
                Aabb& box) {
  if (reach.is_in_link_frame) return placeBox(shape, world_from_link, reach, box);
  return placeBox(shape, world_from_link * shape.link_from_shape, reach, box);
}

/// False if there is no box.
bool placeLink(const BoundedLink& link, const Eigen::Affine3d& world_from_link, LinkReach& reach,
               Aabb& box) {
  if (link.shapes.empty()) return false;
  if (!placeShape(link.shapes[0], world_from_link, reach.shapes[0], box)) return false;
  for (std::size_t i = 1; i < link.shapes.size(); ++i) {
    Aabb part;
    if (!placeShape(link.shapes[i], world_from_link, reach.shapes[i], part)) return false;
    box.extend(part);
  }
  if (link.padding != 0) box = padded(box, link.padding);
  return true;
}

/// A shape with a frame of its own would have its pose computed twice.
void announceLink(const LinkUpdate& update) {
  for (std::size_t i = 0; i < update.link->shapes.size(); ++i) {
    ShapeReach& reach = update.reach->shapes[i];
    if (reach.is_in_link_frame) announce(update.link->shapes[i], *update.world_from_link, reach);
  }
}

void placeUpdate(const LinkUpdate& update) {
  if (!*update.box) update.box->emplace();
  if (!placeLink(*update.link, *update.world_from_link, *update.reach, **update.box)) {
    update.box->reset();
  }
}

}  // namespace

double magnitude(const BoundedLink& link) {
  double result = 0;
  for (const Shape& shape : link.shapes) {
    Eigen::Vector3d own = shape.size / 2;
    if (shape.points) own += shape.points->magnitude();
    const Eigen::Vector3d placed = shape.link_from_shape.linear().cwiseAbs() * own +
                                   shape.link_from_shape.translation().cwiseAbs();
    result = std::max(result, placed.maxCoeff());
  }
  return result;
}

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link,
                            LinkReach& reach) {
  std::optional<Aabb> box(std::in_place);
  if (!placeLink(link, world_from_link, reach, *box)) box.reset();
  return box;
}

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link) {
  LinkReach reach(link);
  return linkBox(link, world_from_link, reach);
}

void updateLinkBoxes(const std::vector<LinkUpdate>& updates) {
  const auto end = updates.end();
  for (auto begin = updates.begin(); begin != end;) {
    const auto stop = begin + std::min<std::ptrdiff_t>(kAtOnce, end - begin);
    std::for_each(begin, stop, announceLink);
    std::for_each(begin, stop, placeUpdate);
    begin = stop;
  }
}

}  // namespace link_bounds
