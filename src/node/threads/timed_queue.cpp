// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Callbacks are called and freed without the lock.
#include "node/threads/timed_queue.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace link_bounds {

TimedQueue::Backlog TimedQueue::backlog() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (entries_.empty()) return {};
  const ros::WallDuration oldest = ros::SteadyTime::now() - entries_.front().arrival;
  return {entries_.size(), std::chrono::nanoseconds(oldest.toNSec())};
}

bool TimedQueue::isEmpty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return entries_.empty();
}

std::size_t TimedQueue::takeMaxWaiting() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(max_waiting_, entries_.size());
}

void TimedQueue::wait(std::chrono::nanoseconds longest) {
  std::unique_lock<std::mutex> lock(mutex_);
  arrival_.wait_for(lock, longest, [this] { return !entries_.empty(); });
}

bool TimedQueue::callOne() {
  Entry entry;
  if (!takeOne(entry)) return false;
  called_ = entry.arrival;
  try {
    if (entry.callback->call() != ros::CallbackInterface::TryAgain) entry.callback.reset();
  } catch (...) {
    entry.callback.reset();
    endCall(std::move(entry));
    throw;
  }
  endCall(std::move(entry));
  return true;
}

bool TimedQueue::takeOne(Entry& entry) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (entries_.empty()) return false;
  entry = std::move(entries_.front());
  entries_.pop_front();
  is_calling_ = true;
  is_caller_removed_ = false;
  caller_ = entry.owner;
  thread_ = std::this_thread::get_id();
  return true;
}

/// A callback that returned TryAgain goes to the end of the queue, unless its owner was removed.
void TimedQueue::endCall(Entry entry) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_calling_ = false;
    if (entry.callback && !is_caller_removed_) entries_.push_back(std::move(entry));
  }
  rest_.notify_all();
}

void TimedQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    entries_.push_back({callback, owner, ros::SteadyTime::now()});
    max_waiting_ = std::max(max_waiting_, entries_.size() + (is_calling_ ? 1 : 0));
  }
  arrival_.notify_one();
}

void TimedQueue::removeByID(std::uint64_t owner) {
  std::deque<Entry> removed;  // freed without the lock
  std::unique_lock<std::mutex> lock(mutex_);
  const auto stays = [owner](const Entry& entry) { return entry.owner != owner; };
  const auto first = std::stable_partition(entries_.begin(), entries_.end(), stays);
  std::move(first, entries_.end(), std::back_inserter(removed));
  entries_.erase(first, entries_.end());
  is_caller_removed_ |= is_calling_ && caller_ == owner;
  lock.unlock();
  removed.clear();  // before the wait: the callback that runs may wait for their end
  lock.lock();
  if (is_calling_ && thread_ == std::this_thread::get_id()) return;
  rest_.wait(lock, [&] { return !is_calling_ || caller_ != owner; });
}

}  // namespace link_bounds
