// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far the points of a body can move while every joint obeys its limits, and so how soon two
// bodies can touch.
//
// Let joint n be the last one before the body, and let it turn by angles up to q about its axis. A
// point at distance l from that axis then moves by at most the chord s = 2 sin(q / 2) l. The joint
// before it then moves a point that may be displaced by s: its distance from that joint's axis is
// at most l' + s, where l' is its distance before the motion. And so on, towards the root:
//
//   s_k = s_(k+1) + 2 sin(q_k / 2) (l_k + s_(k+1))     s_k = s_(k+1) + x_k, if it slides by x_k
//
// with l_k the max distance of a corner of the body's box from axis k. Two bodies that are d apart
// cannot touch before the sum of their s is d. Joints that move both bodies are left out if the
// poses of both have the same stamp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/stopping/body_ways.h"

namespace link_bounds {

class ContactReach {
 public:
  /// The rules must outlive this.
  ContactReach(const BodyWay& way, const Aabb& box, const StopRules& rules);

  /// Max displacement of a point of the body until `time` [ns], if only the joints from index
  /// `first` on move [m].
  double until(std::int64_t time, std::size_t first = 0) const;

  /// Whether any joint moves one body relative to the other.
  bool canMeet(const ContactReach& other) const;

  /// The time before which two bodies that are at least `distance` [m] apart cannot touch [ns]. It
  /// may be up to 1 us too early. Nothing if they cannot touch before `end`.
  std::optional<std::int64_t> earliestContact(const ContactReach& other, double distance,
                                              std::int64_t end) const;

 private:
  struct Step {
    const JointRule* rule;
    std::size_t joint;
    JointState state;
    SpeedRange speed;    ///< at the stamp
    Braking drive;       ///< the joint's max speed, and its acceleration if the speed is known
    double uncertainty;  ///< of its value at the stamp [rad or m]
    double lever;        ///< l_k above [m]
  };

  /// The number of joints, from the root on, that move both bodies; 0 if their stamps differ.
  std::size_t sharedJoints(const ContactReach& other) const;
  double offsetOf(const Step& step, double time) const;

  std::int64_t stamp_;
  std::int64_t begin_;       ///< BodyWay::known
  std::vector<Step> steps_;  ///< the one nearest to the root first
};

}  // namespace link_bounds
