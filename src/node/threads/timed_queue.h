// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A callback queue that tells how many callbacks wait and since when; ros::CallbackQueue does not.
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

/// One thread calls the callbacks, in the order of their arrival; any thread may add some.
class TimedQueue : public ros::CallbackQueueInterface {
 public:
  struct Backlog {
    std::size_t count = 0;
    std::chrono::nanoseconds oldest{0};  ///< for how long the first one waits
  };

  Backlog backlog() const;

  /// The most callbacks that waited or ran at once since the last call.
  std::size_t takeMaxWaiting();

  /// Returns when a callback waits, or after that time.
  void wait(std::chrono::nanoseconds longest);

  /// Calls the one that waits longest; false if none waits.
  bool callOne();

  /// In a callback: when it was added.
  ros::SteadyTime arrival() const { return called_; }

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
  /// Waits while a callback of that owner runs on another thread.
  void removeByID(std::uint64_t owner) override;

 private:
  struct Entry {
    ros::CallbackInterfacePtr callback;
    std::uint64_t owner;
    ros::SteadyTime arrival;
  };

  bool takeOne(Entry& entry);
  void endCall(Entry entry);

  ros::SteadyTime called_;    ///< arrival of the callback that runs; of the calling thread
  mutable std::mutex mutex_;  ///< of everything below
  std::condition_variable arrival_;
  std::condition_variable rest_;  ///< a callback has returned
  std::deque<Entry> entries_;
  std::size_t max_waiting_ = 0;
  bool is_calling_ = false;
  std::uint64_t caller_ = 0;  ///< owner of the callback that runs
  std::thread::id thread_;    ///< that runs it
};

}  // namespace link_bounds
