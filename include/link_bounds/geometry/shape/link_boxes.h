// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The boxes of links that move, updated many times a second.
#pragma once

#include <optional>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"

namespace link_bounds {

/// A link and its new pose, which must stay in memory during the update.
struct MovedLink {
  std::size_t link;  ///< index
  const Eigen::Affine3d* world_from_link;
};

/// The boxes of some links at their last poses. To be fast, it keeps how far each shape extends
/// along the axes of the world, with the linear part of the pose that this holds for. If a row of
/// that part stays the same, only the translation is added anew: the paper's rule for objects that
/// only translate. Nothing else survives an update, so each box has the same bits as that of
/// linkBox(). Updates neither throw nor allocate.
class LinkBoxes {
 public:
  /// Copies the shapes; the links need not live longer.
  explicit LinkBoxes(const std::vector<BoundedLink>& links = {});
  LinkBoxes(LinkBoxes&&) noexcept;
  LinkBoxes& operator=(LinkBoxes&&) noexcept;
  ~LinkBoxes();

  /// Faster than a call per link: prefetches what the batch reads.
  void update(const std::vector<MovedLink>& moved);

  void update(std::size_t link, const Eigen::Affine3d& world_from_link);

  /// The result of linkBox() at the link's last pose; nothing before the first update.
  const std::optional<Aabb>& box(std::size_t link) const { return boxes_[link]; }

 private:
  /// The link's shapes lie one after the other in `shapes_`.
  struct Link {
    std::size_t first_shape;
    std::size_t shapes;
    double padding;
  };
  struct PlacedShape;
  class PrefetchedLists;

  void updateBatch(const MovedLink* begin, const MovedLink* end);
  void bound(const MovedLink& moved, const PrefetchedLists* lists, std::size_t first);
  bool place(const MovedLink& moved, const PrefetchedLists* lists, std::size_t first, Aabb& box);

  std::vector<Link> links_;
  std::vector<PlacedShape> shapes_;
  std::vector<std::optional<Aabb>> boxes_;
};

}  // namespace link_bounds
