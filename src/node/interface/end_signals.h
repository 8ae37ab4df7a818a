// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How signals end a program that is a node.
#pragma once

#include <ros/init.h>
#include <unistd.h>

#include <csignal>

namespace link_bounds {

/// After ros::init() with NoSigintHandler: SIGINT and SIGTERM end the node in order. Where that
/// takes longer than 10 s, as roscpp waits for a master that does not answer, SIGALRM ends the
/// process.
inline void endOnSignals() {
  for (const int number : {SIGINT, SIGTERM}) {
    std::signal(number, [](int) {
      ros::requestShutdown();
      static volatile std::sig_atomic_t is_set = 0;
      if (!is_set) alarm(10);
      is_set = 1;
    });
  }
}

}  // namespace link_bounds
