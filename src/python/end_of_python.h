// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Work without the lock of Python (GIL), on threads that Python does not wait for when it ends,
// such as the callbacks of rospy. If such a thread asks for the lock after that, Python 3.13 and
// older end it with an exception, which cannot leave a destructor: the process would abort.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>

namespace link_bounds {

using StopFlag = std::atomic<bool>;

/// Makes the process stop all work, and wait for it, when Python has ended. Call it once, at the
/// import.
void watchEndOfPython();

/// Marks work that uses no Python, on any thread, until this is destroyed. After the end of Python,
/// the flag is set, and the process waits for the work.
class RunningWork {
 public:
  explicit RunningWork(StopFlag& stop);
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;
  ~RunningWork();

 private:
  StopFlag& stop_;
};

/// Releases the lock until this is destroyed. If Python ends by then, the thread waits in the
/// destructor for ever, as in Python 3.14. So no RunningWork of this thread may outlive this.
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
