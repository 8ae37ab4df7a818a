// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of a simulated clock that jumps, of transforms and of clouds, while the filter
// is now and then busy: each cloud is filtered by the time in which it was sent, or dropped.
#include <cmath>
#include <cstring>
#include <deque>
#include <random>

#include "tools/cloud_filter/simulated_filter.h"

namespace link_bounds {
namespace {

constexpr int kRounds = 20;
constexpr int kSteps = 60;                      // of a round
constexpr std::size_t kClouds = 25;             // of a round; fewer than may wait
constexpr double kHistory = 9;                  // s of tf that are surely kept
constexpr std::uint32_t kManyPoints = 300'000;  // keep the filter busy meanwhile

/// What must become of a cloud.
struct Sent {
  ros::Time stamp;
  bool is_robot;   ///< the cube was at its point
  bool may_drop;   ///< because the clock jumped later, or its time is long ago
  bool is_of_old;  ///< it is from before a jump that the filter has seen: is dropped
};

class RandomJumps : public SimulatedFilter {
 protected:
  RandomJumps() {
    gate_.open();
    output_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/filter_in_process/output", 100,
        [this](const sensor_msgs::PointCloud2ConstPtr& cloud) { take(*cloud); });
    EXPECT_TRUE(becomesTrue([this] { return output_.getNumPublishers() > 0; }));
    EXPECT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  }

  /// In the order of the input; the one that was sent must be among those that may come.
  void take(const sensor_msgs::PointCloud2& cloud) {
    while (!expected_.empty() && expected_.front().stamp != cloud.header.stamp)
      dropFirst();
    ASSERT_FALSE(expected_.empty()) << "a cloud of " << cloud.header.stamp << " came";
    const Sent sent = expected_.front();
    expected_.pop_front();
    ASSERT_FALSE(sent.is_of_old) << "a cloud came that is from before the jump";
    for (std::size_t i = 0; i < cloud.width; i += cloud.width / 7 + 1) {
      float x = 0;
      std::memcpy(&x, &cloud.data[i * cloud.point_step], sizeof x);
      ASSERT_EQ(std::isnan(x), sent.is_robot) << "at " << cloud.header.stamp;
    }
    ++came_;
  }

  void dropFirst() {
    EXPECT_TRUE(expected_.front().may_drop || expected_.front().is_of_old)
        << "the cloud of " << expected_.front().stamp << " is missing";
    expected_.pop_front();
    ++dropped_;
  }

  double draw(double min, double max) {
    return std::uniform_real_distribution<double>(min, max)(random_);
  }
  bool happens(double share) { return draw(0, 1) < share; }

  void goOn(double seconds) {
    now_ += seconds;
    for (Sent& sent : expected_)
      sent.may_drop = sent.may_drop || sent.stamp.toSec() < now_ - kHistory;
    tell(now_, is_robot_ ? 0 : 1);
  }

  /// Nobody has a stamp twice: by it a cloud is recognised.
  ros::Time stampOf(double seconds) {
    ++number_;
    return ros::Time(std::floor(seconds * 1e4) / 1e4 + 1e-9 * number_);
  }

  void jumpBack() {
    const double before = now_;
    now_ = std::max(now_ - draw(0.3, 4), 100.0);
    begin_ = now_;
    is_robot_ = happens(0.5);
    for (Sent& sent : expected_)
      sent.may_drop = true;
    const auto seen = std::chrono::steady_clock::now();
    tellTime(now_);
    const bool is_stale = before > now_ + 0.7 && happens(0.3);
    if (is_stale) {
      const ros::Time stamp = stampOf(draw(now_ + 0.6, before));
      sendCloud(stamp);
      // One that came too long after the jump is taken for one of the new time.
      const bool is_soon = std::chrono::steady_clock::now() - seen < std::chrono::milliseconds(400);
      expected_.push_back({stamp, is_robot_, true, is_soon});
    }
    goOn(0.01);
    begin_ = now_;
  }

  void sendCloudOf(double seconds) {
    const ros::Time stamp = stampOf(seconds);
    expected_.push_back({stamp, is_robot_, false, false});
    sendCloud(stamp, happens(0.1) ? kManyPoints : 1);
    ++clouds_of_round_;
  }

  void step() {
    if (happens(0.06)) {
      jumpBack();
    } else if (happens(0.03)) {  // no jump
      tellTime(now_ - 0.05);
    } else if (happens(0.03)) {
      for (Sent& sent : expected_)
        sent.may_drop = sent.may_drop || sent.stamp.toSec() > now_;  // tf never covers it
      goOn(draw(2.5, 6));
      begin_ = now_;
    } else if (clouds_of_round_ < kClouds && now_ > begin_ && happens(0.4)) {
      sendCloudOf(happens(0.1) ? now_ + draw(0.01, 0.2) : draw(begin_, now_));
    } else {
      goOn(draw(0.01, 0.3));
    }
  }

  std::mt19937 random_;
  ros::Subscriber output_;
  std::deque<Sent> expected_;
  double now_ = kBegin;
  double begin_ = kBegin;  ///< of the transforms that follow each other without a jump
  bool is_robot_ = true;
  std::uint32_t number_ = 0;
  std::size_t clouds_of_round_ = 0, came_ = 0, dropped_ = 0;
};

TEST_F(RandomJumps, NoCloudIsFilteredByAnotherTime) {
  goOn(0);
  for (int round = 0; round < kRounds && !HasFailure(); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    random_.seed(static_cast<unsigned>(round));
    clouds_of_round_ = 0;
    for (int i = 0; i < kSteps && !HasFatalFailure(); ++i)
      step();
    goOn(0.3);  // what waits for tf
    goOn(0.3);
    sendCloudOf(now_);
    EXPECT_TRUE(isServed([this] { return expected_.empty(); })) << expected_.size() << " are open";
  }
  EXPECT_TRUE(isServed([this] {
    return values_["filtered"] == std::to_string(came_) &&
           values_["dropped"] == std::to_string(dropped_);
  })) << values_["filtered"]
      << " of " << came_ << " filtered, " << values_["dropped"] << " of " << dropped_ << " dropped";
  EXPECT_GT(came_, sent_ / 2) << "most clouds are of a time that does not end";
  EXPECT_GT(dropped_, 10U);
}

}  // namespace
}  // namespace link_bounds
