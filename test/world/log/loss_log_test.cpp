// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A loss is reported once, after five seconds, and again only if it ended in between.
#include "world/log/loss_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace link_bounds {
namespace {

using Names = std::vector<std::string>;

class LossLogTest : public testing::Test {
 protected:
  Names due(const Names& lost, double time) {
    Names result;
    for (const std::size_t i : log_.due(lost, ros::SteadyTime(1000 + time)))
      result.push_back(lost[i]);
    return result;
  }

  LossLog log_;
};

TEST_F(LossLogTest, ReportsOnceAfterFiveSeconds) {
  for (double time = 0; time < 5; time += 0.5)
    EXPECT_EQ(due({"arm"}, time), Names());
  EXPECT_EQ(due({"arm"}, 5), Names{"arm"});
  for (double time = 5.5; time < 100; time += 0.5)
    EXPECT_EQ(due({"arm"}, time), Names());
}

TEST_F(LossLogTest, ReportsAgainAfterItWasRight) {
  due({"arm"}, 0);
  EXPECT_EQ(due({"arm"}, 5), Names{"arm"});
  due({}, 6);
  EXPECT_EQ(due({"arm"}, 7), Names());
  EXPECT_EQ(due({"arm"}, 11.5), Names());
  EXPECT_EQ(due({"arm"}, 12), Names{"arm"});
}

/// The rules of LossLog, computed from all calls so far and without other memory.
class History {
 public:
  Names due(const Names& lost, double time) {
    calls_.push_back({time, lost, {}, false});
    Names result;
    for (const std::string& name : lost)
      if (time - lastReport() >= 5 && isDue(name)) result.push_back(name);
    calls_.back().reported = result;
    return result;
  }

  void postpone(const Names& lost, double time) { calls_.push_back({time, lost, {}, true}); }

 private:
  struct Call {
    double time;
    Names lost, reported;
    bool is_postponed;
  };

  static bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  double lastReport() const {
    const auto call = std::find_if(calls_.rbegin(), calls_.rend(),
                                   [](const Call& one) { return !one.reported.empty(); });
    return call == calls_.rend() ? -5 : call->time;
  }

  /// Reads back to where the loss began. The last call that postponed it decides since when.
  bool isDue(const std::string& name) const {
    double since = calls_.back().time;
    bool is_postponed = false;
    for (auto call = calls_.rbegin(); call != calls_.rend() && has(call->lost, name); ++call) {
      if (has(call->reported, name)) return false;
      if (!is_postponed) since = call->time;
      is_postponed |= call->is_postponed;
    }
    return calls_.back().time - since >= 5;
  }

  std::vector<Call> calls_;
};

TEST(LossLog, RandomSequencesAreThoseOfTheWholeHistory) {
  std::size_t reports = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 engine(seed);
    const auto chance = [&engine](unsigned percent) { return engine() % 100 < percent; };
    const Names names{"arm", "hand", "leg"};
    std::vector<bool> is_lost(names.size());
    LossLog log;
    History history;
    for (int step = 0; step < 200; ++step) {
      const double time = 0.5 * step;
      Names lost;
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (chance(5)) is_lost[i] = !is_lost[i];
        if (is_lost[i]) lost.push_back(names[i]);
      }
      const ros::SteadyTime now(1000 + time);
      if (chance(3)) {
        log.postpone(lost, now);
        history.postpone(lost, time);
        continue;
      }
      Names found;
      for (const std::size_t i : log.due(lost, now))
        found.push_back(lost[i]);
      ASSERT_EQ(found, history.due(lost, time)) << "seed " << seed << ", step " << step;
      reports += found.size();
    }
  }
  EXPECT_GT(reports, 500u);
}

}  // namespace
}  // namespace link_bounds
