// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One flag per program.
#include "tools/command_line/interrupt.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <initializer_list>
#include <utility>

namespace link_bounds {
namespace {

std::atomic<bool> interrupted{false};

void onInterrupt(int) {
  interrupted = true;
}

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = onInterrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (const int signal : {SIGINT, SIGTERM})
    sigaction(signal, &action, nullptr);
}

bool isInterrupted() {
  return interrupted;
}

std::function<bool()> overAfter(double seconds, std::function<bool()> is_cancelled) {
  using Clock = std::chrono::steady_clock;
  return [start = Clock::now(), budget = std::chrono::duration<double>(seconds),
          is_cancelled = std::move(is_cancelled)] {
    return is_cancelled() || Clock::now() - start >= budget;
  };
}

}  // namespace link_bounds
