// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The parameters of assert_box, and what they mean together.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "tools/assert_box/box_condition.h"

namespace link_bounds {

/// Meanings and units: visitAssertBoxParameters.
struct AssertBoxParameters {
  std::string topic = "/link_bounds_publisher/boxes";
  std::optional<std::string> name;
  std::optional<std::array<double, 3>> min;
  std::optional<std::array<double, 3>> max;
  std::string check = "equal";
  double tolerance = 1e-6;
  double deadline = 10.0;
  double hold = 0.0;
};

/// What has to become true.
struct BoxAssertion {
  std::string topic;
  std::string name;
  std::string check;
  BoxCondition condition;
  double deadline = 0.0;  ///< wall s
  double hold = 0.0;      ///< wall s
};

/// Throws ParameterError.
BoxAssertion boxAssertion(const AssertBoxParameters& parameters);

/// Reads the private parameters of this node; throws ParameterError, also for a name that means
/// nothing: a test that overlooks a misspelt tolerance would be worse than none.
BoxAssertion readBoxAssertion();

/// What --help prints.
std::string assertBoxUsage();

}  // namespace link_bounds
