// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/end_of_python.h"

#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

namespace py = pybind11;

namespace link_bounds {
namespace {

struct AllWork {
  std::mutex mutex;
  std::condition_variable has_ended;
  std::set<StopFlag*> flags;  ///< of what runs
  std::thread::id ender;      ///< the thread on which Python ends; none before
};

/// Never freed: threads may use it until the process is gone.
AllWork& allWork() {
  static AllWork& all = *new AllWork;
  return all;
}

/// With the lock of Python, so that no work begins meanwhile.
void endWork() {
  AllWork& all = allWork();
  std::unique_lock<std::mutex> lock(all.mutex);
  all.ender = std::this_thread::get_id();
  for (StopFlag* const flag : all.flags)
    *flag = true;
  all.has_ended.wait(lock, [&all] { return all.flags.empty(); });
}

/// Before fork(), so that no other thread has the mutex then.
void lockWork() {
  allWork().mutex.lock();
}

void unlockWork() {
  allWork().mutex.unlock();
}

/// In the new process, which has none of the threads that work.
void forgetWork() {
  allWork().flags.clear();
  unlockWork();
}

bool endsElsewhere() {
  AllWork& all = allWork();
  const std::lock_guard<std::mutex> lock(all.mutex);
  return all.ender != std::thread::id() && all.ender != std::this_thread::get_id();
}

[[noreturn]] void sleepForEver() {
  for (;;)
    ::pause();
}

/// Call it with the lock of Python.
void stopHereAtTheEnd() {
  if (!endsElsewhere()) return;
  PyEval_SaveThread();
  sleepForEver();
}

}  // namespace

void watchEndOfPython() {
  py::module::import("atexit").attr("register")(py::cpp_function(&endWork));
  py::module::import("os").attr("register_at_fork")(
      py::arg("before") = py::cpp_function(&lockWork),
      py::arg("after_in_parent") = py::cpp_function(&unlockWork),
      py::arg("after_in_child") = py::cpp_function(&forgetWork));
}

RunningWork::RunningWork(StopFlag& stop) : stop_(stop) {
  stopHereAtTheEnd();
  const std::lock_guard<std::mutex> lock(allWork().mutex);
  allWork().flags.insert(&stop);
}

RunningWork::~RunningWork() {
  const std::lock_guard<std::mutex> lock(allWork().mutex);
  allWork().flags.erase(&stop_);
  allWork().has_ended.notify_all();
}

Unlocked::Unlocked() : state_(PyEval_SaveThread()) {}

Unlocked::~Unlocked() {
  if (endsElsewhere()) sleepForEver();
  try {
    PyEval_RestoreThread(state_);
  } catch (...) {  // of pthread_exit(): Python began to end while this thread waited for the lock
    sleepForEver();
  }
  stopHereAtTheEnd();
}

}  // namespace link_bounds
