// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The lock is held only briefly: no computation, call or deallocation happens under it.
#include "node/threads/worker.h"

#include <ros/init.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <iterator>
#include <list>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <unordered_map>

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

struct Worker::Inbox {
  mutable std::mutex mutex;  ///< guards all members below
  std::condition_variable wake;
  std::list<Posted> posted;
  std::unordered_map<std::string, std::list<Posted>::iterator> by_key;
  Values discarded;
  std::string running_key;
  std::optional<Clock::time_point> running_since;  ///< since when the running work was posted
  Clock::duration longest{0};  ///< since the last takeLongest(), of completed posted work

  // Changed under the mutex, but read without it. Long work reads these flags often; if it were
  // preempted while it holds the mutex, the update thread would have to wait.
  std::atomic<bool> is_stopped{false};
  std::atomic<bool> is_running_cancelled{false};

  bool isEmpty() const { return posted.empty() && discarded.empty(); }

  Posted take(std::list<Posted>::iterator item) {
    Posted taken = std::move(*item);
    by_key.erase(taken.key);
    posted.erase(item);
    return taken;
  }
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
    if (!key.empty() && inbox_->running_key == key) inbox_->is_running_cancelled = true;
    if (found != inbox_->by_key.end()) {
      std::swap(found->second->work, work);  // the old work is freed without the lock
    } else {
      inbox_->posted.push_back({key, std::move(work), Clock::now()});
      if (!key.empty()) inbox_->by_key[key] = std::prev(inbox_->posted.end());
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
  if (inbox_->running_since) longest = std::max(longest, now - *inbox_->running_since);
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
  std::list<Posted> posted;
  Values discarded;
  const std::lock_guard<std::mutex> lock(inbox_->mutex);
  std::swap(posted, inbox_->posted);
  std::swap(discarded, inbox_->discarded);
  inbox_->by_key.clear();
}

void Worker::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  {
    const std::lock_guard<std::mutex> lock(inbox_->mutex);
    if (inbox_->is_stopped) return;
    urgent_.addCallback(callback, owner);
  }
  inbox_->wake.notify_one();
}

void Worker::removeByID(std::uint64_t owner) {
  urgent_.removeByID(owner);
}

void Worker::run() {
  if (options_.is_nice) beNice();
  while (!isStopping()) {
    Values discarded;
    const Work work = next(discarded);
    discarded.clear();
    if (work) {
      doPosted(work);
    } else if (!inbox_->is_stopped) {
      guarded([this] { urgent_.callOne(); });
    }
  }
}

/// Waits for work. Empty if urgent work comes first, or if none came within a tick period.
Worker::Work Worker::next(Values& discarded) {
  std::unique_lock<std::mutex> lock(inbox_->mutex);
  const auto is_due = [this] {
    return inbox_->is_stopped || !inbox_->isEmpty() || !urgent_.isEmpty();
  };
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
  if (inbox_->is_stopped) return nullptr;
  std::swap(discarded, inbox_->discarded);
  if (inbox_->posted.empty() || !urgent_.isEmpty()) return nullptr;
  Posted item = inbox_->take(inbox_->posted.begin());
  inbox_->running_key = std::move(item.key);
  inbox_->running_since = item.since;
  inbox_->is_running_cancelled = false;
  return std::move(item.work);
}

/// Waits for kHeadStart, unless urgent work comes or the worker is stopped.
void Worker::giveHeadStart(std::unique_lock<std::mutex>& lock) {
  inbox_->wake.wait_for(lock, kHeadStart,
                        [this] { return inbox_->is_stopped || !urgent_.isEmpty(); });
}

void Worker::doPosted(const Work& work) {
  guarded(work);
  const std::lock_guard<std::mutex> lock(inbox_->mutex);
  inbox_->longest = std::max(inbox_->longest, Clock::now() - *inbox_->running_since);
  inbox_->running_since.reset();
  inbox_->running_key.clear();
  inbox_->is_running_cancelled = false;
}

}  // namespace link_bounds
