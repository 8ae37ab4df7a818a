// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Robots of spheres, and when it is said that they touch.
#pragma once

#include <string>

#include "testing/moving_robot.h"

namespace link_bounds {

using Values = MovingRobot::Values;

constexpr double kStamp = MovingRobot::kStamp;

inline std::string sphere(const std::string& name, double radius) {
  return "<link name=\"" + name + "\"><visual><geometry><sphere radius=\"" +
         std::to_string(radius) + "\"/></geometry></visual></link>";
}

inline std::string joint(const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& content) {
  return "<joint name=\"to_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + content + "</joint>";
}

inline Parameters parametersOf(const std::string& fixed_frame, double limit = 1) {
  Parameters parameters;
  parameters.fixed_frame = fixed_frame;
  parameters.distance_limit = limit;
  return parameters;
}

inline void stand(MovingRobot& robot, const Values& values) {
  robot.move(values, Values(values.size(), 0.0));
}

inline double untilOf(const EarliestContactArray& array) {
  return array.valid_until.toSec();
}

}  // namespace link_bounds
