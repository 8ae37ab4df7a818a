// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Publishers whose clocks differ send random messages in any order, and time jumps. What is known
// then is compared with a list of all that was received.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "testing/brute_force.h"
#include "world/stopping/joint_states.h"
#include "world/tf/edge_history.h"

namespace link_bounds {
namespace {

constexpr int kSteps = 2000;
constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kTick = kSecond / 10;
const std::array<std::string, 3> kReported{"a", "b", "c"};

class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : random_(seed) {}

  void run() {
    for (int step = 0; step < kSteps && !testing::Test::HasFailure(); ++step) {
      now_ += below(3) * kTick;
      if (below(100) == 0) now_ = kSecond * (1 + below(100));
      if (below(200) == 0) epoch_ = 1 + static_cast<std::uint64_t>(below(3));
      if (below(50) == 0) observe();
      add();
      compare();
    }
  }

 private:
  std::int64_t below(std::int64_t count) {
    return std::min(static_cast<std::int64_t>(random_.uniform(0, static_cast<double>(count))),
                    count - 1);
  }

  const std::string& joint() { return kReported[static_cast<std::size_t>(below(3))]; }

  void observe() {
    states_.observeEpoch(epoch_);
    if (epoch_ != observed_) received_.clear();
    observed_ = epoch_;
  }

  /// Late by up to 2 s, or of a publisher whose clock is 30 s ahead.
  void add() {
    const std::string& name = joint();
    const std::int64_t ahead = below(40) == 0 ? 30 * kSecond : 0;
    JointReport report{now_ + ahead - below(20) * kTick, random_.uniform(-1, 1), {}};
    if (below(2) == 0) report.velocity = random_.uniform(-1, 1);
    if (below(20) == 0) report.velocity = std::numeric_limits<double>::infinity();
    if (below(50) == 0) report.stamp = 0;
    if (below(50) == 0) report.position = std::nan("");
    states_.add(name, report);
    received_[name].push_back(report);
  }

  /// Of reports, by stamp, with the newest stamp.
  static std::pair<std::map<std::int64_t, JointReport>, std::int64_t> lastTenSeconds(
      const std::vector<JointReport>& reports) {
    std::map<std::int64_t, JointReport> result;
    std::int64_t newest = 0;
    for (const JointReport& report : reports) {
      newest = std::max(newest, report.stamp);
      result.insert_or_assign(report.stamp, report);
      result.erase(result.begin(), result.lower_bound(newest - EdgeHistory::kLength));
    }
    return {result, newest};
  }

  /// What counts of all that was received of the joint, by its stamp: of equal stamps the last one.
  std::map<std::int64_t, JointReport> valid(const std::string& name) const {
    std::map<std::int64_t, JointReport> result;
    const auto found = received_.find(name);
    if (found == received_.end()) return result;
    std::int64_t newest = 0;
    std::vector<JointReport> old;  // in a row, with times of long ago
    for (const JointReport& report : found->second) {
      if (report.stamp <= 0 || !std::isfinite(report.position)) continue;
      if (report.stamp < newest - EdgeHistory::kLength) {
        old.push_back(report);
        const auto [stamps, last] = lastTenSeconds(old);
        if (stamps.size() < 10) continue;
        result = stamps;
        newest = last;
        old.clear();
        continue;
      }
      old.clear();
      newest = std::max(newest, report.stamp);
      result.insert_or_assign(report.stamp, report);
    }
    result.erase(result.begin(), result.lower_bound(newest - EdgeHistory::kLength));
    return result;
  }

  void compare() {
    const std::string& name = joint();
    const std::int64_t stamp = now_ - below(30) * kTick;
    const std::int64_t window = below(20) * kTick;
    std::vector<JointReport> expected;
    const std::map<std::int64_t, JointReport> all = valid(name);
    for (const auto& [when, report] : all) {
      const bool is_next = when > stamp && (expected.empty() || expected.back().stamp < stamp);
      if (when >= stamp - window && (when <= stamp || is_next)) expected.push_back(report);
    }
    const auto next = all.lower_bound(stamp);
    const bool is_there = next != all.begin() && std::prev(next)->first >= stamp - kSecond;
    const auto last = states_.lastBefore(name, stamp);
    ASSERT_EQ(last.has_value(), is_there);
    if (last) {
      EXPECT_EQ(last->stamp, std::prev(next)->first);
    }
    const auto found = states_.reports(name, stamp, window);
    ASSERT_EQ(found.has_value(), !all.empty());
    if (!found) return;
    ASSERT_EQ(found->size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ((*found)[i].stamp, expected[i].stamp);
      EXPECT_EQ((*found)[i].position, expected[i].position);
      const bool has_velocity = expected[i].velocity && std::isfinite(*expected[i].velocity);
      ASSERT_EQ((*found)[i].velocity.has_value(), has_velocity);
      if (has_velocity) {
        EXPECT_EQ(*(*found)[i].velocity, *expected[i].velocity);
      }
    }
  }

  brute_force::Random random_;
  std::int64_t now_ = 50 * kSecond;
  std::uint64_t epoch_ = 0;
  std::uint64_t observed_ = 0;
  JointStates states_;
  std::map<std::string, std::vector<JointReport>> received_;  ///< by joint, since the last epoch
};

TEST(JointStatesRandom, AreWhatWasReceivedSinceTimeJumped) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Sequence(seed).run();
  }
}

}  // namespace
}  // namespace link_bounds
