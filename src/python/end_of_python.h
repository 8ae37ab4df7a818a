// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Work without the lock of Python (GIL), on threads that Python does not wait for when it ends,
// such as the callbacks of rospy. A thread that asks for the lock by then would be ended by
// Python 3.13 and older with an exception, which no destructor lets through: the process would
// abort.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>

namespace link_bounds {

using StopFlag = std::atomic<bool>;

/// From now on the process stops all work and waits for it when Python has ended. Once, at the
/// import.
void watchEndOfPython();

/// Work that uses no Python, from now on until this is destroyed, on whatever thread. After the end
/// of Python the flag is set, and the process waits.
class RunningWork {
 public:
  explicit RunningWork(StopFlag& stop);
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;
  ~RunningWork();

 private:
  StopFlag& stop_;
};

/// The lock is free while this lives. If Python ends by then, the thread stops here for ever, as
/// Python 3.14 has it. No RunningWork of this thread may outlive it.
class Unlocked {
 public:
  Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked();

 private:
  PyThreadState* state_;
};

/// Calls `work`, which is short, on this thread without the lock. Call it with the lock.
template <class Work>
void unlocked(const Work& work) {
  StopFlag unread{false};
  auto running = std::make_unique<RunningWork>(unread);
  const Unlocked others;
  const auto until_the_end = std::move(running);
  work();
}

}  // namespace link_bounds
