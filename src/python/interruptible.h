// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Long work without the GIL, which Ctrl-C ends.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <memory>

#include "python/end_of_python.h"

namespace link_bounds {

/// Calls `work` on a thread of its own, without the GIL, and returns or throws what it does. If a
/// signal handler of Python raises, such as KeyboardInterrupt, the flag is set; `work` should then
/// end, and that exception is thrown. The end of Python sets the flag, too. Call it with the GIL.
template <class Work>
auto interruptible(const Work& work) {
  constexpr std::chrono::milliseconds kBetweenSignals(20);
  StopFlag stop{false};
  auto run = [&work, &stop, running = std::make_unique<RunningWork>(stop)]() mutable {
    const auto until_the_end = std::move(running);
    return work(stop);
  };
  auto result = std::async(std::launch::async, std::move(run));
  for (;;) {
    {
      const Unlocked others;
      if (result.wait_for(kBetweenSignals) == std::future_status::ready) break;
    }
    if (PyErr_CheckSignals() == 0) continue;
    stop = true;
    {
      const Unlocked others;
      result.wait();
    }
    throw pybind11::error_already_set();
  }
  return result.get();
}

}  // namespace link_bounds
