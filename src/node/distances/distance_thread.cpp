// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Waits for a snapshot or a tree, computes, publishes.
#include "node/distances/distance_thread.h"

#include <algorithm>
#include <utility>

#include "node/log/guarded.h"
#include "node/threads/be_nice.h"
#include "node/threads/start_thread.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

/// How late it may request the tree of a mesh that has settled, or notice that nobody listens.
constexpr std::chrono::milliseconds kTick(50);

}  // namespace

DistanceThread::DistanceThread(TreeRequests requests, Callbacks callbacks,
                               std::chrono::milliseconds keep)
    : callbacks_(std::move(callbacks)),
      keep_(keep),
      distances_(requests),
      requests_(std::move(requests)),
      thread_(startThread("distances", [this] { run(); })) {}

void DistanceThread::give(std::shared_ptr<const Snapshot> snapshot) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (inbox_.snapshot && inbox_.snapshot->model != snapshot->model)
      inbox_.replaced.push_back(inbox_.snapshot->model);
    std::swap(inbox_.snapshot, snapshot);
  }
  wake_.notify_one();
}

void DistanceThread::give(MadeTree tree) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    inbox_.trees.push_back(std::move(tree));
  }
  wake_.notify_one();
}

void DistanceThread::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stops_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

DistanceTimes DistanceThread::takeTimes() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(times_, {});
}

std::vector<std::string> DistanceThread::errors() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return errors_;
}

void DistanceThread::run() {
  beNice();
  while (!stops_) {
    guarded([this] { workSafely(); });
  }
}

/// After an exception, such as std::bad_alloc, nothing that was remembered can be trusted.
void DistanceThread::workSafely() {
  try {
    work(next());
  } catch (...) {
    forget();
    throw;
  }
}

/// Waits; empty if nothing came for a tick.
DistanceThread::Inbox DistanceThread::next() {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto is_due = [this] { return stops_ || !inbox_.isEmpty(); };
  if (current_) {
    wake_.wait_for(lock, kTick, is_due);
  } else {
    wake_.wait(lock, is_due);
  }
  return std::exchange(inbox_, {});
}

void DistanceThread::work(Inbox inbox) {
  if (stops_) return;
  const bool has_news = inbox.snapshot || !inbox.trees.empty();
  if (inbox.snapshot) current_ = std::move(inbox.snapshot);
  for (const MadeTree& tree : inbox.trees)
    distances_.trees().add(tree);
  if (has_news && current_) compute();
  distances_.trees().requestSettled(Clock::now());
  callbacks_.tick();
  forgetIfUnwanted();
}

void DistanceThread::compute() {
  const auto begin = Clock::now();
  const auto result = distances_.compute(current_, begin, [this] { return stops_.load(); });
  if (!result) return;
  const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++times_.count;
    times_.sum_ms += ms;
    times_.max_ms = std::max(times_.max_ms, ms);
    errors_ = distances_.trees().errors();
  }
  callbacks_.publish(*result);
}

void DistanceThread::forgetIfUnwanted() {
  if (callbacks_.is_wanted()) last_wanted_ = Clock::now();
  if (current_ && Clock::now() - last_wanted_ >= keep_) forget();
}

void DistanceThread::forget() {
  distances_ = SceneDistances(requests_);
  current_ = nullptr;
}

}  // namespace link_bounds
