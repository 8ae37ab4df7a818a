// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/end_of_python.h"

#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <set>

namespace py = pybind11;

namespace link_bounds {
namespace {

struct AllWork {
  std::mutex mutex;
  std::condition_variable has_ended;
  std::set<StopFlag*> flags;  ///< of running work
};

/// Never freed: threads may use it until the process is gone.
std::atomic<AllWork*> all_work{new AllWork};

/// Runs after the last Python code of the process, and before C++ objects are destroyed.
void endWork() {
  AllWork& all = *all_work;
  std::unique_lock<std::mutex> lock(all.mutex);
  for (StopFlag* const flag : all.flags)
    *flag = true;
  all.has_ended.wait(lock, [&all] { return all.flags.empty(); });
}

/// Runs in a forked process: it has none of the working threads, and one may have held the mutex.
void forgetWork() {
  all_work = new AllWork;
}

}  // namespace

void watchEndOfPython() {
  Py_AtExit(&endWork);
  py::module::import("os").attr("register_at_fork")(py::arg("after_in_child") =
                                                        py::cpp_function(&forgetWork));
}

RunningWork::RunningWork(StopFlag& stop) : stop_(stop) {
  AllWork& all = *all_work;
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.flags.insert(&stop);
}

RunningWork::~RunningWork() {
  AllWork& all = *all_work;
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.flags.erase(&stop_);
  all.has_ended.notify_all();
}

Unlocked::Unlocked() : state_(PyEval_SaveThread()) {}

Unlocked::~Unlocked() {
  try {
    PyEval_RestoreThread(state_);
  } catch (...) {  // thrown by pthread_exit(): Python ends on another thread
    for (;;)
      ::pause();
  }
}

}  // namespace link_bounds
