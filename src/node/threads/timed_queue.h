// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A callback queue that reports how many callbacks wait and since when; ros::CallbackQueue does
// not.
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/time.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <thread>

namespace link_bounds {

/// One thread calls the callbacks in the order of their arrival; any thread may add callbacks.
class TimedQueue : public ros::CallbackQueueInterface {
 public:
  struct Backlog {
    std::size_t count = 0;
    std::chrono::nanoseconds oldest{0};  ///< how long the first callback has waited
  };

  Backlog backlog() const;

  bool isEmpty() const;

  /// The max number of callbacks that waited or ran at the same time since the last call.
  std::size_t takeMaxWaiting();

  /// Returns when a callback waits, at the latest after `longest`.
  void wait(std::chrono::nanoseconds longest);

  /// Calls the callback that has waited longest; false if none waits. Throws what it throws.
  bool callOne();

  /// For use in a callback: the time when that callback was added.
  ros::SteadyTime arrival() const { return called_; }

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
  /// Removes the waiting callbacks of the owner. Waits while one of them runs on another thread.
  void removeByID(std::uint64_t owner) override;

 private:
  struct Entry {
    ros::CallbackInterfacePtr callback;
    std::uint64_t owner;
    ros::SteadyTime arrival;
  };

  bool takeOne(Entry& entry);
  void endCall(Entry entry);

  ros::SteadyTime called_;    ///< arrival of the running callback; of the calling thread
  mutable std::mutex mutex_;  ///< guards all members below
  std::condition_variable arrival_;
  std::condition_variable rest_;  ///< notified when a callback has returned
  std::deque<Entry> entries_;
  std::size_t max_waiting_ = 0;
  bool is_calling_ = false;
  bool is_caller_removed_ = false;  ///< removeByID of its owner came while it ran
  std::uint64_t caller_ = 0;        ///< owner of the running callback
  std::thread::id thread_;          ///< thread of the running callback
};

}  // namespace link_bounds
