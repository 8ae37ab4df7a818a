// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Waits for a moment or a tree, computes, publishes.
#include "node/outputs/distance_thread.h"

#include <algorithm>
#include <utility>

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

/// Period at which the thread requests trees of settled meshes and looks whether somebody listens.
constexpr std::chrono::milliseconds kLookEvery(50);
constexpr std::chrono::seconds kPauseAfterException(1);

}  // namespace

DistanceThread::DistanceThread(TreeRequests requests, MomentPairs& pairs, Callbacks callbacks,
                               std::chrono::milliseconds keep)
    : pairs_(pairs),
      callbacks_(std::move(callbacks)),
      keep_(keep),
      distances_(requests, true),
      requests_(std::move(requests)),
      worker_({"distances", true, [this] { return onTick(); }, kLookEvery}) {}

/// The work only stores the moment; onTick() computes once after all waiting work is done.
void DistanceThread::give(MomentPtr moment) {
  if (published_ == given_) unpublished_since_ = Clock::now();
  worker_.post("moment", [this, moment = std::move(moment), number = ++given_] {
    current_ = moment;
    current_number_ = number;
    has_news_ = true;
  });
}

void DistanceThread::give(MadeTree tree) {
  worker_.post([this, tree = std::move(tree)] {
    distances_.trees().add(tree);
    has_news_ = true;
  });
}

Durations DistanceThread::takeTimes() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(times_, {});
}

/// A moment that waits was given after the last published computation had begun.
double DistanceThread::behind() const {
  if (published_ == given_) return 0;
  const Clock::time_point since = std::max(unpublished_since_.load(), published_begin_.load());
  return std::chrono::duration<double>(Clock::now() - since).count();
}

std::vector<std::string> DistanceThread::errors() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return errors_;
}

/// After an exception, such as std::bad_alloc, no remembered state can be trusted. Forgetting it
/// also needs memory, so it is tried until it succeeds. After a pause the moment is computed again,
/// because no other moment may come. True while there is a moment.
bool DistanceThread::onTick() {
  if (!is_whole_) distances_ = SceneDistances(requests_, true);
  is_whole_ = true;
  try {
    if (Clock::now() >= not_before_ && std::exchange(has_news_, false) && current_) compute();
    distances_.trees().requestSettled(Clock::now());
    callbacks_.tick();
    forgetIfUnwanted();
  } catch (...) {
    is_whole_ = false;
    has_news_ = true;
    not_before_ = Clock::now() + kPauseAfterException;
    if (!callbacks_.is_wanted()) drop();
    throw;
  }
  return current_ != nullptr;
}

void DistanceThread::compute() {
  const auto begin = Clock::now();
  auto result =
      distances_.compute(current_, pairs_, begin, [this] { return worker_.isStopping(); });
  if (!result) return;
  const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    times_.add(ms);
    errors_ = distances_.trees().errors();
  }
  callbacks_.publish(*std::move(result));
  published_begin_ = begin;
  published_ = current_number_;
}

void DistanceThread::forgetIfUnwanted() {
  if (callbacks_.is_wanted()) last_wanted_ = Clock::now();
  if (current_ && Clock::now() - last_wanted_ >= keep_) forget();
}

void DistanceThread::forget() {
  distances_ = SceneDistances(requests_, true);
  drop();
}

/// After this, current_ does not count as waiting, even if it was not published.
void DistanceThread::drop() {
  current_ = nullptr;
  published_ = current_number_;
  const std::lock_guard<std::mutex> lock(mutex_);
  errors_.clear();
}

}  // namespace link_bounds
