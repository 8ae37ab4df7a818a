// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random recordings in which the clock jumps back and messages are late. RecordOrder tells each
// late message, and takes no jump of the clock for one.
#include "tools/bag_bounds/run/record_order.h"

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "testing/brute_force.h"
#include "testing/message_bytes.h"
#include "world/tf/clock_watch.h"

namespace link_bounds {
namespace {

constexpr double kMaxPeriod = 2;  // s, of any publisher

/// They differ by topic, publisher or frame.
struct Publisher {
  std::string topic;
  std::string name;
  std::vector<std::uint8_t> message;
  double period;          // s
  double next = 0;        // time of its next message [s]
  bool has_come = false;  // since the last jump
};

class Recording {
 public:
  explicit Recording(std::uint64_t seed) : random_(seed) {
    const auto count = static_cast<int>(random_.uniform(2, 6));
    for (int i = 0; i < count; ++i) {
      tf2_msgs::TFMessage message;
      message.transforms.resize(1);
      message.transforms[0].child_frame_id = std::to_string(i % 2);
      publishers_.push_back({i < 2 ? "/tf" : "/other_tf", i < 4 ? "/a" : "/b",
                             messageBytes(message), random_.uniform(0.02, kMaxPeriod)});
    }
  }

  void run() {
    for (int event = 0; event < 20; ++event) {
      play(random_.uniform(0, 5));
      if (random_.uniform(0, 1) < 0.5) {
        jump();
      } else {
        beLate();
      }
    }
    play(2 * kMaxPeriod);
  }

  const RecordOrder& order() const { return order_; }
  const std::vector<std::int64_t>& late() const { return late_; }

 private:
  Publisher& nextOne() {
    return *std::min_element(
        publishers_.begin(), publishers_.end(),
        [](const Publisher& a, const Publisher& b) { return a.next < b.next; });
  }

  void send(Publisher& publisher, double time) {
    record(publisher, time);
    publisher.next = time + publisher.period;
    publisher.has_come = true;
  }

  std::int64_t record(const Publisher& publisher, double time) {
    const std::string type = "tf2_msgs/TFMessage";
    ros::Time now(time);
    const auto stamp = static_cast<std::int64_t>(now.toNSec());
    order_.watch({&publisher.topic, &type, &publisher.name, stamp, publisher.message.data(),
                  static_cast<std::uint32_t>(publisher.message.size())},
                 clock_.isJumpBack(now));
    clock_.observe(now);
    return stamp;
  }

  void play(double seconds) {
    const double end = now_ + seconds;
    while (nextOne().next < end) {
      now_ = std::max(now_, nextOne().next);
      send(nextOne(), now_);
    }
    now_ = end;
  }

  /// So far that each publisher goes back, whenever it comes again.
  void jump() {
    now_ -= 2 * kMaxPeriod + random_.uniform(0.2, 5);
    for (Publisher& publisher : publishers_) {
      publisher.next = now_ + random_.uniform(0, publisher.period);
      publisher.has_come = false;
    }
  }

  /// The next message of one publisher comes after those of the others. Of one that has not come
  /// since the last jump, nothing tells a late message from that jump.
  void beLate() {
    Publisher& publisher = publishers_[static_cast<std::size_t>(
        random_.uniform(0, static_cast<double>(publishers_.size())))];
    if (!publisher.has_come) return;
    const double time = std::max(publisher.next, now_);
    publisher.next = 1e9;
    play(time - now_ + random_.uniform(0.3, 4));
    const bool is_step = clock_.isJumpBack(ros::Time(time));
    const std::int64_t stamp = record(publisher, time);
    if (is_step) late_.push_back(stamp);
    publisher.next = std::max(now_, time + publisher.period);
  }

  brute_force::Random random_;
  std::deque<Publisher> publishers_;
  double now_ = 1000;
  ClockWatch clock_;
  RecordOrder order_;
  std::vector<std::int64_t> late_;
};

TEST(RecordOrder, TellsEachLateMessageAndNoJumpOfTheClock) {
  std::size_t late = 0;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Recording recording(seed);
    recording.run();
    EXPECT_EQ(recording.order().stepsBack(), recording.late());
    late += recording.late().size();
  }
  EXPECT_GT(late, 300u);
}

}  // namespace
}  // namespace link_bounds
