// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is stale after random stamps is what a computation without memory finds.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <set>

#include "testing/random_tf.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {
namespace {

constexpr int kLives = 300;
constexpr int kSteps = 200;
constexpr double kTimeout = 2;  // s
constexpr double kYear2023 = 1700000000;

/// A chain map -> link_0 -> link_1 -> ..., of which some edges are static.
class RandomStamps {
 public:
  explicit RandomStamps(std::uint64_t seed) : random_(seed) {
    tracker_.setTarget("map", kTimeout, now());
    for (std::size_t i = 0; i < kLinks; ++i) {
      is_static_[i] = pick(4) == 0;
      handles_[i] = tracker_.follow(name(i));
      offsets_[i] = pick(100) - 50.0;
    }
  }

  void step() {
    if (pick(60) == 0) clear();
    if (pick(60) == 0) distrust();
    const std::size_t link = static_cast<std::size_t>(pick(kLinks));
    if (pick(40) == 0) offsets_[link] += pick(2) == 0 ? 5 - pick(11) : 100 - pick(200);
    send(link, now_ + offsets_[link] - (pick(3) == 0 ? 0.01 * pick(5) : 0));
    tracker_.update(now());
    now_ += pick(20) == 0 ? random_.uniform(0, 4) : random_.uniform(0.01, 0.03);
    if (pick(20) == 0) jumpAhead();
    tracker_.expire(now());
  }

  /// Returns how many are stale.
  int expectSame() const {
    int stale = 0;
    bool is_known = true, is_stale = false;
    for (std::size_t i = 0; i < kLinks; ++i) {
      const Replay replay = replayed(i);
      is_known = is_known && replay.is_known;
      is_stale = is_stale || (!is_static_[i] && replay.received < now_ - kTimeout - kTiny);
      EXPECT_EQ(handles_[i].pose().problem == TransformProblem::kStale, is_known && is_stale) << i;
      stale += is_known && is_stale;
    }
    return stale;
  }

 private:
  static constexpr int kLinks = 5;
  static constexpr double kTiny = 1e-7;  // s; of a double at these times

  /// Something that happened to an edge. Without a stamp: it was cleared or distrusted.
  struct Event {
    double now;
    std::optional<double> stamp;
    bool is_clear = false;
    bool is_jump = false;
  };

  struct Replay {
    bool is_known = false;
    double received = 0;
  };

  static std::string name(std::size_t i) { return "link_" + std::to_string(i); }
  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }
  ros::Time now() const { return ros::Time(now_); }

  void send(std::size_t link, double stamp) {
    stamp = ros::Time(stamp).toSec();
    events_[link].push_back({now_, stamp});
    tf_.add({edge(link == 0 ? "map" : name(link - 1), name(link), stamp,
                  Eigen::Quaterniond::Identity(), {1, 0, 0})},
            is_static_[link], now());
  }

  void clear() {
    tf_.clear();
    for (auto& events : events_)
      events.push_back({now_, {}, true});
    tracker_.updateAll(now());
  }

  /// Often to near the stamps of a publisher whose clock is ahead.
  void jumpAhead() {
    now_ += std::max(3.0, offsets_[pick(kLinks)] + random_.uniform(-1, 1));
    if (tf_.jumpAhead(now())) tracker_.update(now());
    for (auto& events : events_)
      events.push_back({now().toSec(), {}, false, true});
  }

  void distrust() {
    tf_.distrustStampsAhead(now());
    for (auto& events : events_)
      events.push_back({now_, {}, false});
  }

  /// From all that was ever sent: a stamp counts if it is newer than all since the edge began.
  Replay replayed(std::size_t link) const {
    Replay result;
    std::set<double> accepted;
    bool is_distrusted = false;
    for (const Event& event : events_[link]) {
      if (is_static_[link]) {
        result.is_known |= event.stamp.has_value();
        continue;
      }
      const double newest = accepted.empty() ? 0 : *accepted.rbegin();
      if (!event.stamp) {
        if (event.is_clear) accepted.clear();
        if (event.is_jump && std::abs(newest - event.now) <= 0.5) {
          result.received = event.now;
          ++kept_by_jumps;
        }
        if (!event.is_clear && !event.is_jump) is_distrusted = newest > event.now + 10;
        continue;
      }
      const bool is_too_old = !accepted.empty() && *event.stamp < newest - 10 - kTiny;
      if (is_too_old && !is_distrusted) continue;
      if (is_too_old) accepted.clear();
      if (accepted.empty() || *event.stamp > newest || is_too_old) result.received = event.now;
      if (accepted.insert(*event.stamp).second) is_distrusted = false;
    }
    if (!is_static_[link]) result.is_known = !accepted.empty();
    return result;
  }

  brute_force::Random random_;
  TransformBuffer tf_;
  FrameTracker tracker_{tf_};
  FrameTracker::Handle handles_[kLinks];
  bool is_static_[kLinks];
  double offsets_[kLinks];  ///< of the publishers' clocks [s]
  std::vector<Event> events_[kLinks];
  double now_ = kYear2023;

 public:
  mutable long kept_by_jumps = 0;  ///< how often a replay met an edge that a jump kept fresh
};

TEST(NewestStamp, AloneDecidesWhatIsStale) {
  long stale = 0, all = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= kLives && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomStamps life(seed);
    for (int i = 0; i < kSteps && !testing::Test::HasFailure(); ++i) {
      life.step();
      stale += life.expectSame();
      all += 5;
    }
    kept += life.kept_by_jumps;
  }
  std::cout << stale << " of " << all << " links were stale\n";
  EXPECT_GT(stale, all / 20);
  EXPECT_LT(stale, all / 2);
  EXPECT_GT(kept, 1000);
}

}  // namespace
}  // namespace link_bounds
