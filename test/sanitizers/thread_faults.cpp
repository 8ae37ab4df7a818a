// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two threads like those of the node, each with a callback queue of roscpp, and a fault between
// them that ThreadSanitizer must report: thread_faults race|inversion|none
#include <ros/callback_queue.h>

#include <boost/make_shared.hpp>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace {

class QueuedFunction : public ros::CallbackInterface {
 public:
  explicit QueuedFunction(std::function<void()> function) : function_(std::move(function)) {}
  CallResult call() override {
    function_();
    return Success;
  }

 private:
  std::function<void()> function_;
};

void spin(std::function<void()> function) {
  ros::CallbackQueue queue;
  queue.addCallback(boost::make_shared<QueuedFunction>(std::move(function)));
  queue.callAvailable();
}

/// Runs one function on another thread, and one on this.
void spinBoth(const std::function<void()>& theirs, const std::function<void()>& ours) {
  std::thread thread([&] { spin(theirs); });
  spin(ours);
  thread.join();
}

void race(int& count) {
  const auto increment = [&] { ++count; };
  spinBoth(increment, increment);
}

/// One after the other, because at once they might really wait for each other for ever.
void inversion(int& count, std::mutex& first, std::mutex& second) {
  const auto increment = [&](std::mutex& outer, std::mutex& inner) {
    const std::lock_guard<std::mutex> outer_lock(outer);
    const std::lock_guard<std::mutex> inner_lock(inner);
    ++count;
  };
  spinBoth([&] { increment(first, second); }, [] {});
  spinBoth([&] { increment(second, first); }, [] {});
}

void noFault(int& count, std::mutex& mutex) {
  const auto increment = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    ++count;
  };
  spinBoth(increment, increment);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string fault = argc > 1 ? argv[1] : "";
  int count = 0;
  std::mutex first;
  std::mutex second;
  if (fault == "race") race(count);
  if (fault == "inversion") inversion(count, first, second);
  if (fault == "none") noFault(count, first);
  return count == 2 ? 0 : 1;
}
