// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the joints of a robot can be, for proofs about all of its poses.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// A joint follows its leader: value = factor * value of the leader + offset. A joint that mimics
/// no other one is its own leader.
struct Lead {
  std::size_t leader;
  double factor = 1;
  double offset = 0;  ///< rad or m
};

/// One Lead per joint; leaders mimic no joint. Throws JointError for mimic joints that follow each
/// other in a circle or follow no joint.
std::vector<Lead> leadsOf(const Robot& robot);

/// All values of a joint [rad or m], finite and lower <= upper. Those of a joint that follows
/// another one are its values while the leader is in its range.
struct JointRange {
  double lower = 0;
  double upper = 0;
  Lead lead;
  /// A rotation that takes every angle. For a leader, lower and upper are then one turn apart, but
  /// for rounding, unless a joint that follows it is elsewhere after a turn.
  bool is_full_turn = false;
  /// False for a joint that may have any value; lower and upper are then 0.
  bool is_known = true;

  bool isFree() const { return lower < upper; }
};

/// The ranges that the user gives [rad or m], by joint; a fixed value has lower == upper.
using GivenRanges = std::map<std::string, Limits>;

/// One range per joint of the robot. A given range replaces the limits of the URDF and may exceed
/// them. A continuous joint takes every angle. Mimic joints follow; their own limits, and ranges
/// given for them, are ignored. Fixed joints stay at 0. Of a floating or planar joint nothing is
/// known, nor of its parts that are lengths, unless a range is given; its angles take every value.
/// Throws JointError, with the remedy, where any other range is missing or is no range at all.
std::vector<JointRange> jointRanges(const Robot& robot, const GivenRanges& given = {});

}  // namespace link_bounds
