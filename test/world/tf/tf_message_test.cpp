// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Our reading of a TFMessage is roscpp's, and so is what is refused.
#include "world/tf/tf_message.h"

#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"
#include "testing/message_bytes.h"

namespace link_bounds {
namespace {

const Eigen::Quaterniond kMessageTurn(Eigen::AngleAxisd(M_PI / 4,
                                                        Eigen::Vector3d(1, 2, 3).normalized()));

void read(const std::vector<std::uint8_t>& bytes, TfMessage& message) {
  message.read(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
}

tf2_msgs::TFMessage threeTransforms() {
  tf2_msgs::TFMessage message;
  message.transforms = {edge("base", "a", 1.5, kMessageTurn, {1, 2, 3}),
                        edge("/a", "/b", 2.5, kMessageTurn, {4, 5, 6}),
                        edge("", std::string(100000, 'x'), 0, kMessageTurn, {7, 8, 9})};
  return message;
}

TEST(TfMessage, IsReadAsRoscppReadsIt) {
  const tf2_msgs::TFMessage sent = threeTransforms();
  TfMessage message;
  read(messageBytes(sent), message);
  ASSERT_EQ(message.transforms.size(), sent.transforms.size());
  for (std::size_t i = 0; i < sent.transforms.size(); ++i) {
    const TransformView expected(sent.transforms[i]);
    EXPECT_EQ(message.transforms[i].parent, expected.parent);
    EXPECT_EQ(message.transforms[i].child, expected.child);
    EXPECT_EQ(message.transforms[i].stamp, expected.stamp);
    EXPECT_EQ(message.transforms[i].parent_from_child.numbers, expected.parent_from_child.numbers);
  }
  EXPECT_EQ(message.transforms[1].parent, "a");
  EXPECT_EQ(message.transforms[1].child, "b");
}

TEST(TfMessage, ShorterOnesLeaveNothingOfLongerOnes) {
  TfMessage message;
  read(messageBytes(threeTransforms()), message);
  read(messageBytes(tf2_msgs::TFMessage()), message);
  EXPECT_TRUE(message.transforms.empty());
}

TEST(TfMessage, CutOffAnywhereIsAnError) {
  tf2_msgs::TFMessage sent = threeTransforms();
  sent.transforms.pop_back();
  std::vector<std::uint8_t> bytes = messageBytes(sent);
  TfMessage message;
  while (!bytes.empty()) {
    bytes.pop_back();
    EXPECT_THROW(read(bytes, message), ros::serialization::StreamOverrunException) << bytes.size();
  }
}

TEST(TfMessage, LyingCountsAndLengthsAreErrors) {
  TfMessage message;
  EXPECT_THROW(read({255, 255, 255, 255}, message), ros::serialization::StreamOverrunException);
  std::vector<std::uint8_t> bytes = messageBytes(threeTransforms());
  std::fill(bytes.begin() + 16, bytes.begin() + 20, 255);  // the length of the first frame_id
  EXPECT_THROW(read(bytes, message), ros::serialization::StreamOverrunException);
}

tf2_msgs::TFMessage manyTransforms(std::size_t count) {
  tf2_msgs::TFMessage message;
  message.transforms.assign(count, edge("a", "b", 1.5, kMessageTurn, {1, 2, 3}));
  return message;
}

TEST(TfMessageMemory, IsUsedAgainUnlessSomebodyHoldsIt) {
  TfMessageMemory memory;
  read(messageBytes(manyTransforms(1000)), *memory.lend());
  memory.giveBack();
  const auto first = memory.lend();
  EXPECT_GT(first->capacity(), 1000 * sizeof(TransformView));
  EXPECT_NE(memory.lend(), first);
}

TEST(TfMessageMemory, WhatIsSkippedHasNoTransforms) {
  TfMessageMemory memory;
  read(messageBytes(threeTransforms()), *memory.lend());
  memory.skip(true);
  const auto skipped = memory.lend();
  read(messageBytes(threeTransforms()), *skipped);
  EXPECT_TRUE(skipped->is_skipped);
  EXPECT_TRUE(skipped->transforms.empty());
  EXPECT_NO_THROW(read({255, 255, 255, 255}, *skipped)) << "it is not looked at";
  memory.skip(false);
  const auto next = memory.lend();
  read(messageBytes(threeTransforms()), *next);
  EXPECT_FALSE(next->is_skipped);
  EXPECT_EQ(next->transforms.size(), 3u);
}

TEST(TfMessageMemory, OfALargeMessageIsGivenBack) {
  TfMessageMemory memory;
  read(messageBytes(manyTransforms(300000)), *memory.lend());
  EXPECT_GT(memory.lend()->capacity(), 50000000u);
  memory.giveBack();
  EXPECT_EQ(memory.lend()->capacity(), 0u);
}

}  // namespace
}  // namespace link_bounds
