// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What assert_box asks of a box, and for how long.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

enum class BoxCheck {
  kEqual,    ///< each of the six coordinates is that of `wanted`
  kInside,   ///< the box lies in `wanted`
  kOutside,  ///< the two boxes do not overlap
};

struct BoxCondition {
  BoxCheck check = BoxCheck::kEqual;
  Aabb wanted;             ///< equal: finite; else an infinite coordinate is a side without limit
  double tolerance = 0.0;  ///< m
};

/// Metres by which a box fails the check, or, if not positive, keeps it. Equal: the largest
/// difference of a coordinate. Inside: how far it reaches out of `wanted`. Outside: how far it
/// would have to move along an axis until the two only touch. Infinite if it is no box: NaN, min >
/// max.
double excess(const BoxCondition& condition, const Aabb& box);

/// True if there are boxes, all of which keep the check within the tolerance.
bool isSatisfied(const BoxCondition& condition, const std::vector<Aabb>& boxes);

/// Watches whether something stays true for long enough, once; times are seconds of a steady clock.
class Hold {
 public:
  explicit Hold(double seconds) : seconds_(seconds) {}

  void update(bool is_true, double now);
  bool isKept(double now) const;
  /// The longest time so far that it stayed true.
  double longest(double now) const;

 private:
  double seconds_;
  std::optional<double> since_;  ///< none while it is not true
  double longest_ = 0.0;
  bool was_kept_ = false;  ///< before since_
};

/// "[x, y, z] to [x, y, z]" with nine digits.
std::string boxText(const Aabb& box);

}  // namespace link_bounds
