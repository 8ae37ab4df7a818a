// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A thread with an inbox. All work for other threads of the node goes through this class.
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
#include <vector>

#include "node/threads/timed_queue.h"

namespace link_bounds {

/// Urgent work goes first: callbacks of roscpp, such as service calls whose NodeHandle has this
/// worker as its queue. Then comes posted work, in order. Exceptions of work are logged.
class Worker : public ros::CallbackQueueInterface {
 public:
  using Work = std::function<void()>;

  struct Options {
    std::string name;  ///< name of the thread, for the error if it cannot be started
    /// A nice thread gives way to other threads when cores are scarce. If it was idle, it waits 1
    /// ms before it begins posted work.
    bool is_nice = false;
    /// Called on the thread whenever no work is waiting, also at the start. Called again every
    /// `tick_period` for as long as it returns true or throws.
    std::function<bool()> on_tick = [] { return false; };
    std::chrono::milliseconds tick_period{50};
  };

  /// Throws std::runtime_error if the thread cannot be started.
  explicit Worker(Options options);
  ~Worker() override { stop(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // All functions may be called on any thread and return at once, unless stated otherwise.

  /// Replaces work that waits under the same key, and keeps its place. A stopped worker ignores the
  /// call.
  void post(const std::string& key, Work work);

  /// The same without a key: the work is never replaced.
  void post(Work work) { post("", std::move(work)); }

  /// The longest time from post() to the end of the work since the last call, including work that
  /// still runs or waits. For work that replaced other work, the time counts from the first post().
  std::chrono::nanoseconds takeLongest();

  /// Drops the work that waits under the key, and cancels running work of that key: see
  /// isCancelled().
  void cancel(const std::string& key);

  /// For work that takes long: true if the worker stops, or if the running work was cancelled or
  /// replaced under its key. Takes no lock, and neither does isStopping().
  bool isCancelled() const;

  /// True after stop(), and while roscpp shuts down.
  bool isStopping() const;

  /// Call on the worker's thread. Has the thread that serves `queue` call `piece` until it returns
  /// true; that thread handles other callbacks in between. Throws what `piece` throws. Returns
  /// false, and `piece` is not called again, if the worker is stopping or the deadline passes.
  bool await(ros::CallbackQueueInterface& queue, std::function<bool()> piece,
             std::chrono::steady_clock::time_point deadline =
                 std::chrono::steady_clock::time_point::max());

  /// A pointer to the value, which only the worker's thread frees, whichever thread drops the last
  /// reference. After stop(), the thread that drops it frees it.
  template <class T>
  std::shared_ptr<const T> owned(std::shared_ptr<const T> value) {
    const T* const address = value.get();
    return {address, [inbox = inbox_, value = std::move(value)](const T*) mutable {
              discard(*inbox, std::move(value));
            }};
  }

  /// Ends the thread after its current work. Waiting work is dropped.
  void stop();

  // ros::CallbackQueueInterface, for urgent work. A callback that returns TryAgain is called again
  // after the urgent work that waits.
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
  /// Removes the callbacks of the owner. Waits while one of them runs on the thread.
  void removeByID(std::uint64_t owner) override;

 private:
  struct Inbox;
  struct Posted;
  using Values = std::vector<std::shared_ptr<const void>>;

  static void discard(Inbox& inbox, std::shared_ptr<const void> value);
  void run();
  Work next(Values& discarded);
  void giveHeadStart(std::unique_lock<std::mutex>& lock);
  void doPosted(const Work& work);

  Options options_;
  std::shared_ptr<Inbox> inbox_;  ///< shared, because values from owned() may outlive the worker
  TimedQueue urgent_;             ///< callbacks are added under the mutex of the inbox
  std::thread thread_;
};

}  // namespace link_bounds
