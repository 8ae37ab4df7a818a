// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The distances of bodies that move, asked for many times a second.
#pragma once

#include <memory>

#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {

/// Some bodies at their last poses. To be fast, it remembers of each pair which parts were nearest,
/// and the next search of that pair begins there. A memory ends when one of the two bodies is
/// replaced, or with forgetUnused(). The bounds of find() are as tight as those of bodyDistance(),
/// but their values may differ within goal.tolerance(). A memory takes up to 97 KiB for a pair of
/// meshes and less than 1 KiB for others. Throws nothing but std::bad_alloc. Not thread-safe. A
/// moved-from object may only be assigned to or destroyed.
class BodyDistances {
 public:
  explicit BodyDistances(const DistanceGoal& goal = {});
  BodyDistances(BodyDistances&&) noexcept;
  BodyDistances& operator=(BodyDistances&&) noexcept;
  ~BodyDistances();

  /// Adds or replaces a body, which then has no pose. Null removes it. Indices should be small:
  /// there is memory for all smaller ones.
  void set(std::size_t index, std::shared_ptr<const Body> body);

  void move(std::size_t index, const Eigen::Affine3d& world_from_body);

  void setGoal(const DistanceGoal& goal);

  /// Nothing if one of the two bodies does not exist, has no pose yet, or has no finite box at its
  /// last pose. While neither body moves, a result that reaches the goal stays the same, unless the
  /// boxes of the bodies alone prove the limit.
  std::optional<BodyDistance> find(std::size_t first, std::size_t second);

  /// As find(), but does not search while the bodies have moved so little, relative to each other,
  /// that the last result of the pair is still good enough: its lower bound less that motion, and
  /// its points carried along with the bodies. Both bounds are proven, and as near to each other as
  /// those of find(). Poses that scale or mirror are searched each time.
  std::optional<BodyDistance> follow(std::size_t first, std::size_t second);

  /// As find(), with another limit [m], and remembers nothing of the pair.
  std::optional<BodyDistance> findOnce(std::size_t first, std::size_t second, double limit) const;

  /// Forgets the pairs that neither find() nor follow() was asked for since the last call.
  void forgetUnused();

 private:
  struct Memories;
  std::unique_ptr<Memories> memories_;
};

}  // namespace link_bounds
