// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The union of the boxes of a link's shapes.
#include "link_bounds/geometry/shape/link_boxes.h"

#include <algorithm>
#include <array>

#include "geometry/shape/shape_steps.h"

namespace link_bounds {
namespace {

/// Links of which everything that is prefetched stays in the nearest cache.
constexpr std::ptrdiff_t kLinksAtOnce = 16;
constexpr std::size_t kShapesAtOnce = 64;

/// What one batch prefetched for its shapes, one after the other. The cells follow from the poses
/// of the batch alone and end with it; shapes beyond the last place look theirs up themselves.
class BatchCells {
 public:
  void prefetch(const LinkUpdate& update) {
    const std::vector<Shape>& shapes = update.link->shapes;
    for (std::size_t i = 0; i < shapes.size() && count_ < kShapesAtOnce; ++i, ++count_) {
      const ShapeReach& reach = update.reach->shapes[i];
      // A shape with a frame of its own would have its pose computed twice.
      const bool is_found =
          reach.is_in_link_frame &&
          prefetchCells(shapes[i], *update.world_from_link, reach, cells_[count_]);
      if (!is_found) cells_[count_][0] = nullptr;
    }
  }

  /// Of the shape with this number in the batch; null if there are none.
  const CellsOfRows* at(std::size_t shape) const {
    return shape < count_ && cells_[shape][0] ? &cells_[shape] : nullptr;
  }

 private:
  std::size_t count_ = 0;
  std::array<CellsOfRows, kShapesAtOnce> cells_;  ///< null: none
};

bool placeShape(const Shape& shape, const Eigen::Affine3d& world_from_link,
                const CellsOfRows* cells, ShapeReach& reach, Aabb& box) {
  if (reach.is_in_link_frame) return placeBox(shape, world_from_link, cells, reach, box);
  return placeBox(shape, world_from_link * shape.link_from_shape, nullptr, reach, box);
}

/// False if there is no box. `first` is the number of the link's first shape in the batch.
bool placeLink(const BoundedLink& link, const Eigen::Affine3d& world_from_link,
               const BatchCells& cells, std::size_t first, LinkReach& reach, Aabb& box) {
  if (link.shapes.empty()) return false;
  if (!placeShape(link.shapes[0], world_from_link, cells.at(first), reach.shapes[0], box)) {
    return false;
  }
  for (std::size_t i = 1; i < link.shapes.size(); ++i) {
    Aabb part;
    if (!placeShape(link.shapes[i], world_from_link, cells.at(first + i), reach.shapes[i], part)) {
      return false;
    }
    box.extend(part);
  }
  if (link.padding != 0) box = padded(box, link.padding);
  return true;
}

void placeUpdate(const LinkUpdate& update, const BatchCells& cells, std::size_t first) {
  if (!*update.box) update.box->emplace();
  if (!placeLink(*update.link, *update.world_from_link, cells, first, *update.reach,
                 **update.box)) {
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
  BatchCells nothing_prefetched;
  if (!placeLink(link, world_from_link, nothing_prefetched, 0, reach, *box)) box.reset();
  return box;
}

std::optional<Aabb> linkBox(const BoundedLink& link, const Eigen::Affine3d& world_from_link) {
  LinkReach reach(link);
  return linkBox(link, world_from_link, reach);
}

void updateLinkBoxes(const std::vector<LinkUpdate>& updates) {
  const auto end = updates.end();
  for (auto begin = updates.begin(); begin != end;) {
    const auto stop = begin + std::min<std::ptrdiff_t>(kLinksAtOnce, end - begin);
    BatchCells cells;
    std::for_each(begin, stop, [&](const LinkUpdate& update) { cells.prefetch(update); });
    std::size_t first = 0;
    for (auto update = begin; update != stop; ++update) {
      placeUpdate(*update, cells, first);
      first += update->link->shapes.size();
    }
    begin = stop;
  }
}

}  // namespace link_bounds
