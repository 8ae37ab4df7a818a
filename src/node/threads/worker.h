// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A thread with an inbox: the one way to give work to another thread.
#pragma once

#include <ros/callback_queue_interface.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace link_bounds {

/// Urgent work goes first: callbacks of roscpp, such as calls of a service whose NodeHandle has
/// this worker as its queue. Then comes what was posted, in order. Work that throws is logged.
class Worker : public ros::CallbackQueueInterface {
 public:
  using Work = std::function<void()>;

  struct Options {
    std::string name;  ///< of the thread, for the error if it cannot be started
    /// A nice thread gives way to others where cores are scarce. If it was idle, it waits 1 ms
    /// before it begins with what is posted.
    bool is_nice = false;
    /// Called on the thread at its start, after all that waits was done, and then every
    /// `tick_period` while it returns true or throws.
    std::function<bool()> on_tick = [] { return false; };
    std::chrono::milliseconds tick_period{50};
  };

  /// Throws std::runtime_error if the thread cannot be started.
  explicit Worker(Options options);
  ~Worker() override { stop(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // All functions may be called on any thread and, unless they say so, return at once.

  /// Work that waits under the same key is replaced, in its place. A worker that is stopped takes
  /// none.
  void post(const std::string& key, Work work);

  /// How long the work that took longest since the last call took from its post() to its end, also
  /// of what runs or waits now. Work that replaced other work has waited since that was posted.
  std::chrono::nanoseconds takeLongest();

  /// Forgets the work that waits under the key, and tells the one that runs: see isCancelled().
  void cancel(const std::string& key);

  /// For work that takes long: true if the worker stops, or if the work that runs was cancelled or
  /// has a successor under its key. Takes no lock, and neither does isStopping().
  bool isCancelled() const;

  /// True from stop() on, and while roscpp shuts down.
  bool isStopping() const;

  /// On the worker's thread: has `piece` called on the thread that serves `queue` until it returns
  /// true. That thread does what else waits in between. Throws what `piece` throws. False, and
  /// `piece` is not called any more, if the worker is stopping or the deadline passes.
  bool await(ros::CallbackQueueInterface& queue, std::function<bool()> piece,
             std::chrono::steady_clock::time_point deadline =
                 std::chrono::steady_clock::time_point::max());

  /// The value, which only the worker's thread frees, whoever drops the last reference. After
  /// stop() that thread itself frees it.
  template <class T>
  std::shared_ptr<const T> owned(std::shared_ptr<const T> value) {
    const T* const address = value.get();
    return {address, [inbox = inbox_, value = std::move(value)](const T*) mutable {
              discard(*inbox, std::move(value));
            }};
  }

  /// Ends the thread after what it is working on. What waits is not done.
  void stop();

  // Of ros::CallbackQueueInterface: urgent work. A callback that returns TryAgain is called again
  // after the urgent work that waits.
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
  /// Waits while a callback of that owner runs on the thread.
  void removeByID(std::uint64_t owner) override;

 private:
  struct Inbox;
  struct Posted;
  struct Urgent;
  struct Next;

  static void discard(Inbox& inbox, std::shared_ptr<const void> value);
  void run();
  Next next();
  void giveHeadStart(std::unique_lock<std::mutex>& lock);
  void doUrgent(Urgent urgent);
  void doPosted(const Work& work);

  Options options_;
  std::shared_ptr<Inbox> inbox_;  ///< values that were given away may outlive the worker
  std::thread thread_;
};

}  // namespace link_bounds
