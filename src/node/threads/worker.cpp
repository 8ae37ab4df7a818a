// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The lock is held only briefly: no computation, call or deallocation happens under it.
#include "node/threads/worker.h"

#include <ros/init.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <iterator>
#include <list>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <unordered_map>
#include <vector>

#include "node/threads/be_nice.h"
#include "node/threads/queued_function.h"
#include "world/log/guarded.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll(20);  // max delay until await() notices a shutdown

/// await() first polls for this time without sleeping. The other thread is mostly done before a
/// sleeping thread would wake up: without this, a request of ~get_boxes for 50 links takes 1.2
/// times as long (`scripts/bench get-boxes`).
constexpr std::chrono::microseconds kAwake(200);

/// An idle nice worker waits this long before it begins posted work. The work follows from boxes
/// that were just published, and the threads that send them need the processors. With subscribers
/// on all topics about future motion, the 99th percentile of the age of the boxes was 1.9 times as
/// high without this wait, and 1.0 times with it (`scripts/bench overload --stopping`).
constexpr std::chrono::milliseconds kHeadStart(1);

/// Throws std::runtime_error with the name of the thread and a remedy.
std::thread startThread(const std::string& name, const std::function<void()>& body) {
  try {
    return std::thread(body);
  } catch (const std::system_error& error) {
    throw std::runtime_error("cannot start the " + name + " thread: " + error.what() +
                             "; raise the limits of threads and of memory (ulimit -u, ulimit -v)");
  }
}

/// Shared by await() and the thread that calls the piece.
struct Awaited {
  std::mutex mutex;  ///< held while `piece` is called
  std::condition_variable ready;
  std::function<bool()> piece;  ///< guarded by mutex; empty after await() has returned
  std::exception_ptr error;     ///< guarded by mutex
  std::atomic<bool> is_done{false};
};

void callPiece(const std::shared_ptr<Awaited>& awaited, ros::CallbackQueueInterface& queue) {
  {
    const std::lock_guard<std::mutex> lock(awaited->mutex);
    if (!awaited->piece) return;
    try {
      awaited->is_done = awaited->piece();
    } catch (...) {
      awaited->error = std::current_exception();
      awaited->is_done = true;
    }
  }
  if (awaited->is_done) {
    awaited->ready.notify_one();
  } else {
    enqueue(queue, [awaited, &queue] { callPiece(awaited, queue); });
  }
}

}  // namespace

struct Worker::Posted {
  std::string key;
  Work work;
  Clock::time_point since;
};

struct Worker::Urgent {
  ros::CallbackInterfacePtr callback;
  std::uint64_t owner;
};

struct Worker::Inbox {
  mutable std::mutex mutex;  ///< guards all members below
  std::condition_variable wake;
  std::condition_variable rest;  ///< notified when urgent work was done
  std::deque<Urgent> urgent;
  std::list<Posted> posted;
  std::unordered_map<std::string, std::list<Posted>::iterator> by_key;
  std::vector<std::shared_ptr<const void>> discarded;
  std::thread::id thread;
  std::string running_key;
  Clock::time_point running_since;
  Clock::duration longest{0};  ///< since the last takeLongest(), of completed posted work
  std::uint64_t running_owner = 0;
  bool is_urgent_running = false;
  bool is_urgent_removed = false;  ///< removeByID() was called for the urgent work that runs

  // Changed under the mutex, but read without it. Long work reads these flags often; if it were
  // preempted while it holds the mutex, the update thread would have to wait.
  std::atomic<bool> is_stopped{false};
  std::atomic<bool> is_running_cancelled{false};

  bool isEmpty() const { return urgent.empty() && posted.empty() && discarded.empty(); }

  Posted take(std::list<Posted>::iterator item) {
    Posted taken = std::move(*item);
    by_key.erase(taken.key);
    posted.erase(item);
    return taken;
  }
};

/// The next actions of the thread: objects to free, and one piece of work.
struct Worker::Next {
  std::vector<std::shared_ptr<const void>> discarded;
  Urgent urgent{nullptr, 0};
  Work work;
};

Worker::Worker(Options options)
    : options_(std::move(options)),
      inbox_(std::make_shared<Inbox>()),
      thread_(startThread(options_.name, [this] { run(); })) {}

void Worker::post(const std::string& key, Work work) {
  {
    const std::lock_guard<std::mutex> lock(inbox_->mutex);
    if (inbox_->is_stopped) return;
    const auto found = inbox_->by_key.find(key);
    if (inbox_->running_key == key) inbox_->is_running_cancelled = true;
    if (found != inbox_->by_key.end()) {
      std::swap(found->second->work, work);  // the old work is freed without the lock
    } else {
      inbox_->posted.push_back({key, std::move(work), Clock::now()});
      inbox_->by_key[key] = std::prev(inbox_->posted.end());
    }
  }
  inbox_->wake.notify_one();
}

void Worker::cancel(const std::string& key) {
  Posted cancelled;  // is freed without the lock
  const std::lock_guard<std::mutex> lock(inbox_->mutex);
  if (inbox_->running_key == key) inbox_->is_running_cancelled = true;
  const auto found = inbox_->by_key.find(key);
  if (found != inbox_->by_key.end()) cancelled = inbox_->take(found->second);
}

std::chrono::nanoseconds Worker::takeLongest() {
  const std::lock_guard<std::mutex> lock(inbox_->mutex);
  const Clock::time_point now = Clock::now();
  Clock::duration longest = std::exchange(inbox_->longest, Clock::duration(0));
  if (!inbox_->running_key.empty()) longest = std::max(longest, now - inbox_->running_since);
  for (const Posted& item : inbox_->posted)
    longest = std::max(longest, now - item.since);
  return longest;
}

bool Worker::isCancelled() const {
  return isStopping() || inbox_->is_running_cancelled;
}

/// ros::ok() stays true during a shutdown, while roscpp waits for running service calls.
bool Worker::isStopping() const {
  if (ros::isInitialized() && (ros::isShuttingDown() || !ros::ok())) return true;
  return inbox_->is_stopped;
}

bool Worker::await(ros::CallbackQueueInterface& queue, std::function<bool()> piece,
                   Clock::time_point deadline) {
  const auto awaited = std::make_shared<Awaited>();
  awaited->piece = std::move(piece);
  enqueue(queue, [awaited, &queue] { callPiece(awaited, queue); });
  const auto end = Clock::now() + kAwake;
  while (!awaited->is_done && Clock::now() < end)
    std::this_thread::yield();
  std::unique_lock<std::mutex> lock(awaited->mutex);
  while (!awaited->ready.wait_for(lock, kPoll, [&] { return awaited->is_done.load(); })) {
    if (isStopping() || Clock::now() >= deadline) break;
  }
  awaited->piece = nullptr;
  if (awaited->error) std::rethrow_exception(awaited->error);
  return awaited->is_done;
}

void Worker::discard(Inbox& inbox, std::shared_ptr<const void> value) {
  {
    const std::lock_guard<std::mutex> lock(inbox.mutex);
    if (inbox.is_stopped) return;
    inbox.discarded.push_back(std::move(value));
  }
  inbox.wake.notify_one();
}

void Worker::stop() {
  {
    const std::lock_guard<std::mutex> lock(inbox_->mutex);
    inbox_->is_stopped = true;
  }
  inbox_->wake.notify_one();
  if (thread_.joinable()) thread_.join();
  inbox_->rest.notify_all();
  std::deque<Urgent> urgent;
  std::list<Posted> posted;
  std::vector<std::shared_ptr<const void>> discarded;
  const std::lock_guard<std::mutex> lock(inbox_->mutex);
  std::swap(urgent, inbox_->urgent);
  std::swap(posted, inbox_->posted);
  std::swap(discarded, inbox_->discarded);
  inbox_->by_key.clear();
}

void Worker::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  {
    const std::lock_guard<std::mutex> lock(inbox_->mutex);
    if (inbox_->is_stopped) return;
    inbox_->urgent.push_back({callback, owner});
  }
  inbox_->wake.notify_one();
}

void Worker::removeByID(std::uint64_t owner) {
  std::vector<Urgent> removed;  // is freed without the lock
  std::unique_lock<std::mutex> lock(inbox_->mutex);
  auto& urgent = inbox_->urgent;
  const auto stays = [owner](const Urgent& entry) { return entry.owner != owner; };
  const auto first = std::stable_partition(urgent.begin(), urgent.end(), stays);
  std::move(first, urgent.end(), std::back_inserter(removed));
  urgent.erase(first, urgent.end());
  if (inbox_->is_urgent_running && inbox_->running_owner == owner) inbox_->is_urgent_removed = true;
  lock.unlock();
  removed.clear();
  lock.lock();
  if (std::this_thread::get_id() != inbox_->thread) {
    inbox_->rest.wait(lock,
                      [&] { return !inbox_->is_urgent_running || inbox_->running_owner != owner; });
  }
}

void Worker::run() {
  if (options_.is_nice) beNice();
  {
    const std::lock_guard<std::mutex> lock(inbox_->mutex);
    inbox_->thread = std::this_thread::get_id();
  }
  while (!isStopping()) {
    Next todo = next();
    todo.discarded.clear();
    if (todo.urgent.callback) {
      doUrgent(std::move(todo.urgent));
    } else if (todo.work) {
      doPosted(todo.work);
    }
  }
}

/// Waits for work. Empty if none came within a tick period.
Worker::Next Worker::next() {
  Next todo;
  std::unique_lock<std::mutex> lock(inbox_->mutex);
  const auto is_due = [this] { return inbox_->is_stopped || !inbox_->isEmpty(); };
  if (!is_due()) {
    lock.unlock();
    bool ticks = true;
    guarded([&] { ticks = options_.on_tick(); });
    lock.lock();
    if (ticks) {
      inbox_->wake.wait_for(lock, options_.tick_period, is_due);
    } else {
      inbox_->wake.wait(lock, is_due);
    }
    if (options_.is_nice && !inbox_->posted.empty()) giveHeadStart(lock);
  }
  if (inbox_->is_stopped) return todo;
  std::swap(todo.discarded, inbox_->discarded);
  if (!inbox_->urgent.empty()) {
    todo.urgent = std::move(inbox_->urgent.front());
    inbox_->urgent.pop_front();
    inbox_->is_urgent_running = true;
    inbox_->is_urgent_removed = false;
    inbox_->running_owner = todo.urgent.owner;
  } else if (!inbox_->posted.empty()) {
    Posted item = inbox_->take(inbox_->posted.begin());
    todo.work = std::move(item.work);
    inbox_->running_key = std::move(item.key);
    inbox_->running_since = item.since;
    inbox_->is_running_cancelled = false;
  }
  return todo;
}

/// Waits for kHeadStart, unless urgent work comes or the worker is stopped.
void Worker::giveHeadStart(std::unique_lock<std::mutex>& lock) {
  inbox_->wake.wait_for(lock, kHeadStart,
                        [this] { return inbox_->is_stopped || !inbox_->urgent.empty(); });
}

void Worker::doUrgent(Urgent urgent) {
  auto result = ros::CallbackInterface::Invalid;
  guarded([&] { result = urgent.callback->call(); });
  if (result != ros::CallbackInterface::TryAgain) urgent.callback.reset();
  {
    const std::lock_guard<std::mutex> lock(inbox_->mutex);
    inbox_->is_urgent_running = false;
    if (urgent.callback && !inbox_->is_urgent_removed) inbox_->urgent.push_back(std::move(urgent));
  }
  inbox_->rest.notify_all();
}

void Worker::doPosted(const Work& work) {
  guarded(work);
  const std::lock_guard<std::mutex> lock(inbox_->mutex);
  inbox_->longest = std::max(inbox_->longest, Clock::now() - inbox_->running_since);
  inbox_->running_key.clear();
  inbox_->is_running_cancelled = false;
}

}  // namespace link_bounds
