// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds how far the points of a body can move while every joint obeys its limits, and from that
// how soon two bodies can touch.
//
// Let joint n be the last one before the body, and let it turn by angles up to q about its axis. A
// point at distance l from that axis then moves by at most the chord s = 2 sin(q / 2) l. So its
// distance from the axis of the joint before that is at most l' + s, if it was l', and so on:
//
//   s_k = s_(k+1) + 2 sin(q_k / 2) (l_k + s_(k+1))     s_k = s_(k+1) + x_k, if joint k slides by
//   x_k
//
// with l_k the largest distance of a corner of the body's box from axis k. Two bodies at distance d
// cannot touch before the sum of their s is d. Joints that move both of them count for neither, if
// the poses of both have the same stamp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/stopping/body_ways.h"

namespace link_bounds {

class ContactReach {
 public:
  /// `rules` must outlive this.
  ContactReach(const BodyWay& way, const Aabb& box, const StopRules& rules);

  /// Max distance [m] by which any point of the body can move until `time` [ns], while the joints
  /// from index `first` on move.
  double until(std::int64_t time, std::size_t first = 0) const;

  friend std::size_t sharedJoints(const ContactReach& a, const ContactReach& b);
  friend bool canMeet(const ContactReach& a, const ContactReach& b);
  friend std::optional<std::int64_t> earliestContact(const ContactReach& a, const ContactReach& b,
                                                     double distance, std::int64_t end);

 private:
  struct Step {
    const JointRule* rule;
    std::size_t joint;
    JointState state;
    SpeedRange speed;    ///< at the stamp
    Braking drive;       ///< limits of its acceleration and speed
    double uncertainty;  ///< of its value at the stamp [rad or m]
    double lever;        ///< l_k above [m]; 0 for a sliding joint
  };

  double offsetOf(const Step& step, double time) const;

  std::int64_t stamp_;
  std::int64_t begin_;       ///< BodyWay::known
  std::vector<Step> steps_;  ///< the one nearest to the root first
};

/// The number of joints, counted from the root, that move both; 0 if their stamps differ.
std::size_t sharedJoints(const ContactReach& a, const ContactReach& b);

/// Whether any joint moves one of the two relative to the other.
bool canMeet(const ContactReach& a, const ContactReach& b);

/// The time [ns] before which two bodies cannot touch if their distance is at least `distance` [m].
/// It is at most 1 us too early. Nothing if they cannot touch before `end`.
std::optional<std::int64_t> earliestContact(const ContactReach& a, const ContactReach& b,
                                            double distance, std::int64_t end);

}  // namespace link_bounds
