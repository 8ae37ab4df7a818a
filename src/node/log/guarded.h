// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Callbacks of a running node must not throw: roscpp does not catch exceptions.
#pragma once

#include <ros/console.h>

#include <exception>
#include <functional>

#include "node/log/log_text.h"

namespace link_bounds {

/// Runs the body of a callback and lets no exception out.
using Guard = std::function<void(const std::function<void()>& body)>;

/// Calls `body`. An exception is logged, at most once per second.
template <class Body>
void guarded(Body&& body) {
  try {
    body();
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(1, "unexpected: %s", logText(error.what()).c_str());
  }
}

}  // namespace link_bounds
