// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages are answered in the order in which they were sent, maybe several by one.
#include "node/load/ages.h"

#include <algorithm>
#include <ostream>

namespace link_bounds {
namespace {

constexpr std::chrono::milliseconds kWatchPeriod(2);

double milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

void Ages::send(ros::Time stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  numbers_[stamp.toNSec()] = sent_.size();
  sent_.push_back(Clock::now());
}

void Ages::answer(ros::Time stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = numbers_.find(stamp.toNSec());
  if (found == numbers_.end() || found->second < ages_.size()) return;
  ++updates_;
  while (ages_.size() <= found->second)
    ages_.push_back(waitingSince(ages_.size()));
}

bool Ages::isAllAnswered() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ages_.size() == sent_.size();
}

double Ages::waiting() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ages_.size() < sent_.size() ? waitingSince(ages_.size()) : 0;
}

double Ages::waitingSince(std::size_t number) const {
  return milliseconds(Clock::now() - sent_[number]);
}

void Ages::print(std::ostream& out) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<double> ages = ages_;
  while (ages.size() < sent_.size())
    ages.push_back(waitingSince(ages.size()));
  std::sort(ages.begin(), ages.end());
  const auto quantile = [&](double part) {
    return ages.empty() ? 0 : ages[static_cast<std::size_t>(part * double(ages.size() - 1))];
  };
  out << "\"sent\": " << sent_.size() << ", \"updates\": " << updates_
      << ", \"unanswered\": " << sent_.size() - ages_.size() << ", \"p50_ms\": " << quantile(0.5)
      << ", \"p99_ms\": " << quantile(0.99) << ", \"max_ms\": " << quantile(1);
}

StallWatch::StallWatch() : thread_([this] { run(); }) {}

StallWatch::~StallWatch() {
  ends_ = true;
  thread_.join();
}

void StallWatch::run() {
  while (!ends_) {
    const auto due = std::chrono::steady_clock::now() + kWatchPeriod;
    std::this_thread::sleep_until(due);
    const double late = milliseconds(std::chrono::steady_clock::now() - due);
    if (late > longest_) longest_ = late;
  }
}

}  // namespace link_bounds
