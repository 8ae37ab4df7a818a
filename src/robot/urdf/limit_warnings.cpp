// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/urdf/limit_warnings.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "text/joined.h"

namespace link_bounds {

bool isBeyond(const Limits& limits, double value) {
  constexpr double kRounding = 1e-9;
  return value < limits.lower - kRounding * std::max(1.0, std::abs(limits.lower)) ||
         value > limits.upper + kRounding * std::max(1.0, std::abs(limits.upper));
}

std::string beyondLimits(const Robot& robot, const GivenRanges& given) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  for (const Joint& joint : robot.joints) {
    const auto found = given.find(joint.name);
    if (found == given.end() || joint.mimic || !joint.limits) continue;
    const auto [lower, upper] = *joint.limits;
    const auto [from, to] = found->second;
    if (from >= lower && to <= upper) continue;
    text << (text.tellp() > 0 ? ", \"" : "\"") << joint.name << "\" at " << from;
    if (from < to) text << " to " << to;
    text << " (limits " << lower << " to " << upper << ")";
  }
  return text.tellp() > 0 ? "beyond the limits of its joint in the URDF: " + text.str() : "";
}

std::string equalLimits(const Robot& robot, const GivenRanges& given) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    const bool is_still = joint.limits && joint.limits->lower == joint.limits->upper;
    if (!is_still || joint.mimic || given.count(joint.name)) continue;
    names.push_back(joint.name);
  }
  if (names.empty()) return "";
  return "the lower limit is equal to the upper one, so these joints stay there: " +
         quotedList(names);
}

}  // namespace link_bounds
