// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The distances of bodies that move, asked for many times a second.
#pragma once

#include <memory>

#include "link_bounds/geometry/distance/body_distance.h"

namespace link_bounds {

/// Some bodies at their last poses, and the one owner of what makes distances fast: of each pair it
/// remembers what was nearest, and the next search of that pair begins there. A memory ends when
/// one of the two bodies is replaced, or with forgetUnused(). Bounds of find() and of
/// bodyDistance() hold alike and are as near to each other, but they may differ within
/// goal.tolerance(). A memory takes up to 97 KiB for a pair of meshes and less than 1 KiB for
/// others. Throws nothing but std::bad_alloc. Not thread-safe. A moved-from object may only be
/// assigned to or destroyed.
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

  /// Nothing if one of the two is not there, has had no pose, or has no finite box in its last one.
  /// While neither body moves, what reaches the goal stays the same, unless the boxes of the bodies
  /// alone prove the limit.
  std::optional<BodyDistance> find(std::size_t first, std::size_t second);

  /// As find(), but searches nothing where both bodies have moved so little, relative to each
  /// other, that what the last search of the pair found is still good enough: its lower bound,
  /// less that motion, and its points, carried along with the bodies. Both bounds are proven as
  /// those of find(), and as near to each other. Poses that scale or mirror are searched each time.
  std::optional<BodyDistance> follow(std::size_t first, std::size_t second);

  /// As find(), with another limit [m], and remembers nothing of the pair.
  std::optional<BodyDistance> findOnce(std::size_t first, std::size_t second, double limit) const;

  /// Forgets the pairs that neither find() nor follow() was asked for since the last call.
  void forgetUnused();

 private:
  class Memories;
  std::unique_ptr<Memories> memories_;
};

}  // namespace link_bounds
