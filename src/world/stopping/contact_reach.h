// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far the points of a body can move while every joint obeys its limits, and so how soon two
// bodies can touch.
//
// Let joint n be the last one before the body, and let it turn by angles up to q about its axis. A
// point at distance l from that axis then moves by at most the chord 2 sin(q / 2) l. The joint
// before it may meet the point anywhere within that path s of where it is, so at a distance from
// its own axis of at most l' + s, and so on:
//
//   s_k = s_(k+1) + 2 sin(q_k / 2) (l_k + s_(k+1))     s_k = s_(k+1) + x_k, if it slides by x_k
//
// with l_k the largest distance of a corner of the body's box from axis k. Two bodies that are d
// apart cannot touch before the sum of their s is d. Joints above both of them count for neither,
// if their poses have the same stamp.
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

  /// How far a point of the body may be from where it is, at any moment until that time [ns], while
  /// the joints from that one on move [m].
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
    Braking drive;       ///< how it speeds up
    double uncertainty;  ///< of where it is at the stamp [rad or m]
    double lever;        ///< [m]
  };

  double offsetOf(const Step& step, double time) const;

  std::int64_t stamp_;
  std::int64_t begin_;       ///< BodyWay::known
  std::vector<Step> steps_;  ///< the one nearest to the root first
};

/// The number of joints at the root that both have, or 0 if their stamps differ.
std::size_t sharedJoints(const ContactReach& a, const ContactReach& b);

/// Whether a joint moves one of the two relative to the other.
bool canMeet(const ContactReach& a, const ContactReach& b);

/// Until when two bodies that are at least so far apart [m] cannot touch [ns]; nothing if they
/// cannot before `end` either. It is rounded down to 1 us.
std::optional<std::int64_t> earliestContact(const ContactReach& a, const ContactReach& b,
                                            double distance, std::int64_t end);

}  // namespace link_bounds
