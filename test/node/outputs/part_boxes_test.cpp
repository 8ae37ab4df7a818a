// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts have the poses of the boxes in the moment.
#include "node/outputs/messages/part_boxes.h"

#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

/// The parts of each link are a copy of it and a larger copy.
std::shared_ptr<const Model> modelInParts(int parts_per_link) {
  auto model = std::make_shared<Model>(*modelOf("base", {meshLink("arm", 1), meshLink("lost", 2)}));
  model->parameters.parts_per_link = parts_per_link;
  for (const BoundedLink& link : model->links) {
    BoundedLink larger = link;
    larger.padding = 1;
    model->parts.push_back({link, larger});
  }
  return model;
}

class PartBoxesTest : public testing::Test {
 protected:
  void adopt(const std::shared_ptr<const Model>& model) { scene_.adopt(model, ros::Time(1)); }

  void turn(double degrees) {
    const double stamp = ++stamp_;
    const Eigen::Quaterniond rotation(brute_force::turned(degrees, {1, 2, 3}));
    tf_.add({edge("base", "arm", stamp, rotation, {1, 2, 3})}, false, ros::Time(stamp));
    scene_.update(ros::Time(stamp));
  }

  TransformBuffer tf_;
  Scene scene_{tf_};
  PartBoxes parts_;
  AxisAlignedBoxArray message_;
  int stamp_ = 1;
};

TEST_F(PartBoxesTest, AreWantedOnlyIfThereAreSeveral) {
  adopt(modelInParts(2));
  EXPECT_TRUE(parts_.fill(*momentOf(scene_), message_));
  adopt(modelInParts(1));
  EXPECT_FALSE(parts_.fill(*momentOf(scene_), message_));
}

TEST_F(PartBoxesTest, FollowTheLinkHoweverSeldomTheyAreAskedFor) {
  adopt(modelInParts(2));
  for (const int turns : {1, 3, 1}) {
    for (int i = 0; i < turns; ++i)
      turn(30 + 15 * i);
    parts_.fill(*momentOf(scene_), message_);
    ASSERT_EQ(message_.boxes.size(), 2u);
    const Aabb box = *scene_.links.states()[0].box;
    const Aabb larger = padded(box, 1);
    EXPECT_EQ(message_.boxes[0].min.x, box.min().x());
    EXPECT_EQ(message_.boxes[1].max.z, larger.max().z());
    EXPECT_EQ(message_.boxes[1].name, "arm");
    EXPECT_EQ(message_.boxes[1].stamp, ros::Time(stamp_));
    EXPECT_EQ(message_.header.stamp, ros::Time(stamp_));
  }
}

TEST_F(PartBoxesTest, AgreeWithTheMomentAfterTheLinksHaveMovedOn) {
  adopt(modelInParts(2));
  turn(30);
  const Aabb box = *scene_.links.states()[0].box;
  const auto moment = momentOf(scene_);
  turn(60);
  parts_.fill(*moment, message_);
  EXPECT_EQ(message_.boxes[0].min.x, box.min().x());
  EXPECT_EQ(message_.boxes[0].stamp, ros::Time(stamp_ - 1));
}

TEST_F(PartBoxesTest, BelongToTheModelOfTheMoment) {
  adopt(modelInParts(2));
  turn(30);
  const auto before = momentOf(scene_);
  parts_.fill(*before, message_);
  adopt(modelInParts(3));
  turn(45);
  parts_.fill(*momentOf(scene_), message_);
  EXPECT_EQ(message_.boxes[0].min.x, scene_.links.states()[0].box->min().x());
  parts_.fill(*before, message_);
  EXPECT_EQ(message_.boxes[0].stamp, ros::Time(stamp_ - 1));
}

TEST_F(PartBoxesTest, NameALinkWithoutBoxOnce) {
  adopt(modelInParts(2));
  turn(45);
  parts_.fill(*momentOf(scene_), message_);
  EXPECT_EQ(message_.incomplete, std::vector<std::string>{"lost"});
}

}  // namespace
}  // namespace link_bounds
