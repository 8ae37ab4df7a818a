// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The rule that a running node never throws: roscpp does not catch what a callback throws.
#pragma once

#include <ros/console.h>

#include <exception>
#include <functional>

#include "node/log/log_text.h"

namespace link_bounds {

/// Runs the body of a callback where nothing can be thrown out of it.
using Guard = std::function<void(const std::function<void()>& body)>;

/// Calls the body of a callback; an exception becomes one log line per second.
template <class Body>
void guarded(Body&& body) {
  try {
    body();
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(1, "unexpected: %s", logText(error.what()).c_str());
  }
}

}  // namespace link_bounds
