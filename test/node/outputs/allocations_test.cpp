// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the bytes of a tf message to filled messages, our code takes no memory from the heap, but
// for the moment that other threads share.
#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <cmath>
#include <iostream>

#include "node/outputs/messages/box_message.h"
#include "node/outputs/messages/overlap_message.h"
#include "node/outputs/messages/part_boxes.h"
#include "testing/live_boxes_testing.h"
#include "testing/replaced_new.h"
#include "world/tf/tf_message.h"

namespace link_bounds {
namespace {

constexpr int kLinks = 50;
constexpr int kSwing = 50;        // updates in which the chain moves to and fro
constexpr double kPeriod = 0.01;  // s
constexpr int kWarmUp = 3000;  // updates, until histories have their ten seconds, and memory for it
constexpr int kUpdates = 1000;

/// Requests of our code and of roscpp, whose message code is compiled into this program, too.
struct Counts {
  long ours = 0;
  long moments = 0;
  long roscpp = 0;
};

Counts counts;

/// A chain of links with long names, each turned a little differently at each update.
class Chain {
 public:
  Chain() {
    std::vector<BoundedLink> links;
    for (int i = 0; i < kLinks; ++i)
      links.push_back(meshLink(name(i), static_cast<std::uint64_t>(i)));
    auto model = std::make_shared<Model>(*modelOf("the_frame_that_is_fixed", links));
    model->parameters.parts_per_link = 2;
    for (const BoundedLink& link : links)
      model->parts.push_back({link, link});
    scene_.adopt(model, ros::Time(1));
  }

  /// What arrives from the network.
  ros::SerializedMessage message(int update) const {
    tf2_msgs::TFMessage message;
    const double angle = 0.5 + 0.5 * std::sin(2 * M_PI * update / kSwing);
    for (int i = 0; i < kLinks; ++i) {
      const std::string parent = i == 0 ? "the_frame_that_is_fixed" : name(i - 1);
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
      message.transforms.push_back(
          edge(parent, name(i), 1 + kPeriod * update, turn, {0.1, 0.2, 0.3}));
    }
    return ros::serialization::serializeMessage(message);
  }

  void update(const ros::SerializedMessage& received, int update) {
    ros::serialization::deserializeMessage(received, message_);
    const ros::Time now(1 + kPeriod * update);
    tf_.add(message_.transforms, false, now);
    ASSERT_TRUE(scene_.update(now));
    fillBoxes(scene_, boxes_);
    fillGroups(scene_, groups_);
    long* const counter = replaced_new::counter;
    if (counter) replaced_new::counter = &counts.moments;
    const MomentPtr moment = momentOf(scene_);
    replaced_new::counter = counter;
    ASSERT_TRUE(parts_.fill(*moment, parts_message_));
    overlap_filler_.fill(moment, pairs_, overlaps_);
    if (counter) replaced_new::counter = &counts.roscpp;
    ros::serialization::serializeMessage(boxes_);
    ros::serialization::serializeMessage(groups_);
    ros::serialization::serializeMessage(parts_message_);
    ros::serialization::serializeMessage(overlaps_);
    replaced_new::counter = counter;
  }

  std::size_t boxCount() const { return boxes_.boxes.size(); }
  std::size_t partCount() const { return parts_message_.boxes.size(); }
  std::size_t overlapCount() const { return overlaps_.overlaps.size(); }

 private:
  static std::string name(int i) { return "a_link_whose_name_is_long_" + std::to_string(i); }

  TfMessage message_;
  TransformBuffer tf_;
  Scene scene_{tf_};
  AxisAlignedBoxArray boxes_;
  AxisAlignedBoxArray groups_;
  PartBoxes parts_;
  AxisAlignedBoxArray parts_message_;
  MomentPairs pairs_;
  OverlapFiller overlap_filler_;
  BoxOverlapArray overlaps_;
};

TEST(Allocations, NoneOfOursInAThousandUpdates) {
  Chain chain;
  for (int i = 0; i < kWarmUp + kUpdates; ++i) {
    const ros::SerializedMessage received = chain.message(i);
    if (i >= kWarmUp) replaced_new::counter = &counts.ours;
    chain.update(received, i);
    replaced_new::counter = nullptr;
  }
  EXPECT_EQ(chain.boxCount(), static_cast<std::size_t>(kLinks));
  EXPECT_EQ(chain.partCount(), static_cast<std::size_t>(2 * kLinks));
  EXPECT_GT(chain.overlapCount(), 0u);
  EXPECT_EQ(counts.ours, 0);
  EXPECT_GT(counts.roscpp, 0);
  EXPECT_LE(counts.moments, 3 * kUpdates);  // itself, its bodies, and the name of the fixed frame
  std::cout << "allocations in " << kUpdates << " updates of " << kLinks << " links: ours "
            << counts.ours << ", for moments " << counts.moments << ", roscpp's for sending "
            << counts.roscpp << "\n";
}

TEST(Allocations, AreSeenWhereThereAreSome) {
  long count = 0;
  replaced_new::counter = &count;
  const std::string text(100, 'x');
  replaced_new::counter = nullptr;
  EXPECT_EQ(count, 1) << text;
}

}  // namespace
}  // namespace link_bounds
