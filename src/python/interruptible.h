// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Long work without the GIL, which Ctrl-C ends.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>

namespace link_bounds {

using StopFlag = std::atomic<bool>;

/// Calls `work` on a thread of its own, without the GIL, and returns what it returns or throws. If
/// a signal of Python throws, as KeyboardInterrupt does, the flag is set; `work` should then end,
/// and that exception is thrown. Call it with the GIL.
template <class Work>
auto interruptible(const Work& work) {
  constexpr std::chrono::milliseconds kBetweenSignals(20);
  StopFlag stop{false};
  auto result = std::async(std::launch::async, [&] { return work(stop); });
  for (;;) {
    {
      const pybind11::gil_scoped_release others;
      if (result.wait_for(kBetweenSignals) == std::future_status::ready) break;
    }
    if (PyErr_CheckSignals() == 0) continue;
    stop = true;
    {
      const pybind11::gil_scoped_release others;
      result.wait();
    }
    throw pybind11::error_already_set();
  }
  return result.get();
}

}  // namespace link_bounds
