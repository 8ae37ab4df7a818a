// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which messages of /tf wait, and when roscpp drops some.
#include "node/inputs/tf_receiver.h"

#include <gtest/gtest.h>
#include <std_msgs/Empty.h>

#include <optional>

#include "node/threads/timed_queue.h"
#include "testing/own_master.h"
#include "testing/patience.h"

namespace link_bounds {
namespace {

class TfReceiverTest : public testing::Test {
 protected:
  TfReceiverTest() {
    ros::NodeHandle tf_node, fence_node;
    tf_node.setCallbackQueue(&queue_);
    fence_node.setCallbackQueue(&fence_queue_);
    tf_ = tf_node.advertise<tf2_msgs::TFMessage>("/tf", 1);
    fence_ = fence_node.advertise<std_msgs::Empty>("/fence", 1);
    fence_subscriber_ = fence_node.subscribe<std_msgs::Empty>(
        "/fence", 1, [this](const std_msgs::EmptyConstPtr&) { has_fence_ = true; });
    receiver_.emplace(tf_node, [this](const TfReceiver::Event&, bool) { ++received_; });
    EXPECT_TRUE(
        becomesTrue([this] { return tf_.getNumSubscribers() + fence_.getNumSubscribers() == 2; }));
  }

  /// Returns when all wait, or were dropped. roscpp sends on a thread of its own, topic by topic:
  /// only the second fence is surely behind them.
  void send(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      tf_.publish(tf2_msgs::TFMessage());
    for (int i = 0; i < 2; ++i) {
      has_fence_ = false;
      fence_.publish(std_msgs::Empty());
      ASSERT_TRUE(becomesTrue([this] {
        fence_queue_.callOne();
        return has_fence_;
      }));
    }
  }

  /// How many callbacks were called.
  std::size_t takeAll() {
    const std::size_t before = received_;
    while (queue_.callOne()) {
    }
    return received_ - before;
  }

  OwnMaster master_{"tf_receiver_test"};
  TimedQueue queue_, fence_queue_;
  bool has_fence_ = false;
  std::size_t received_ = 0;
  ros::Publisher tf_, fence_;
  ros::Subscriber fence_subscriber_;
  std::optional<TfReceiver> receiver_;
};

/// By how many waited at once one can tell whether roscpp may have dropped some.
TEST_F(TfReceiverTest, RoscppDropsOnlyWhereSoManyWait) {
  send(TfReceiver::kQueue - 1);
  EXPECT_EQ(takeAll(), TfReceiver::kQueue - 1);
  EXPECT_EQ(queue_.takeMaxWaiting(), TfReceiver::kQueue - 1);
  EXPECT_EQ(queue_.takeMaxWaiting(), 0u);
  send(TfReceiver::kQueue + 7);
  EXPECT_EQ(takeAll(), TfReceiver::kQueue);
  EXPECT_EQ(queue_.takeMaxWaiting(), TfReceiver::kQueue);
}

}  // namespace
}  // namespace link_bounds
