// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a link keeps of its last pose never reaches a box it does not belong to.
#include "world/bodies/live_boxes.h"

#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

const Eigen::Quaterniond kTurn(Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d(1, 2, 3).normalized()));

class LiveBoxesTest : public testing::Test {
 protected:
  void adopt(const BoundedLink& link) { scene_.adopt(modelOf("base", {link}), now_); }

  void move(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& translation) {
    now_ += ros::Duration(0.1);
    tf_.add({edge("base", "l", now_.toSec(), rotation, translation)}, false, now_);
    scene_.update(now_);
  }

  void expectBoxOf(const BoundedLink& link, const Eigen::Vector3d& translation) {
    Eigen::Affine3d pose(kTurn);
    pose.pretranslate(translation);
    const Aabb expected = linkBox(link, pose).value();
    ASSERT_TRUE(scene_.links.states()[0].box);
    EXPECT_LT((scene_.links.states()[0].box->min() - expected.min()).norm(), 1e-12);
    EXPECT_LT((scene_.links.states()[0].box->max() - expected.max()).norm(), 1e-12);
  }

  TransformBuffer tf_;
  Scene scene_{tf_};
  ros::Time now_{1000.0};
};

TEST_F(LiveBoxesTest, WithoutAModelNothingHappens) {
  tf_.add({}, false, now_);
  EXPECT_FALSE(scene_.update(now_));
  move(kTurn, {1, 2, 3});
  EXPECT_FALSE(scene_.restart(now_));
  EXPECT_FALSE(scene_.expire(now_));
  EXPECT_TRUE(scene_.links.states().empty());
}

TEST_F(LiveBoxesTest, StandingStillOnlyChangesTheStamp) {
  const BoundedLink link = meshLink("l", 1);
  adopt(link);
  move(kTurn, {1, 2, 3});
  const Aabb before = scene_.links.states()[0].box.value();
  move(kTurn, {1, 2, 3});
  EXPECT_EQ(scene_.links.states()[0].stamp, static_cast<std::int64_t>(now_.toNSec()));
  EXPECT_EQ(scene_.links.states()[0].box->min(), before.min());
  EXPECT_EQ(scene_.links.states()[0].box->max(), before.max());
}

TEST_F(LiveBoxesTest, SameRotationAfterAStaleGap) {
  const BoundedLink link = meshLink("l", 1);
  adopt(link);
  move(kTurn, {1, 2, 3});
  expectBoxOf(link, {1, 2, 3});
  now_ += ros::Duration(5);
  EXPECT_TRUE(scene_.expire(now_));
  EXPECT_FALSE(scene_.links.states()[0].box);
  move(kTurn, {-1, 0, 2});
  expectBoxOf(link, {-1, 0, 2});
}

TEST_F(LiveBoxesTest, SameRotationAfterAReloadWithAnotherMesh) {
  adopt(meshLink("l", 1));
  move(kTurn, {1, 2, 3});
  const BoundedLink other = meshLink("l", 2);
  adopt(other);
  expectBoxOf(other, {1, 2, 3});
  move(kTurn, {4, 5, 6});
  expectBoxOf(other, {4, 5, 6});
}

TEST_F(LiveBoxesTest, SameRotationByTheOppositeQuaternion) {
  const BoundedLink link = meshLink("l", 1);
  adopt(link);
  move(kTurn, {1, 2, 3});
  const Aabb before = scene_.links.states()[0].box.value();
  move(Eigen::Quaterniond(-kTurn.coeffs()), {1, 2, 3});
  EXPECT_EQ(scene_.links.states()[0].box->min(), before.min());
  EXPECT_EQ(scene_.links.states()[0].box->max(), before.max());
}

TEST_F(LiveBoxesTest, AReparentedLinkIsBoundedAnew) {
  const BoundedLink link = meshLink("l", 1);
  adopt(link);
  move(kTurn, {1, 2, 3});
  tf_.add({edge("base", "other", now_.toSec(), Eigen::Quaterniond::Identity(), {5, 0, 0})}, true,
          now_);
  now_ += ros::Duration(0.1);
  tf_.add({edge("other", "l", now_.toSec(), kTurn, {1, 2, 3})}, false, now_);
  scene_.update(now_);
  expectBoxOf(link, {6, 2, 3});
}

/// A cube that a half turn about z maps onto itself; true if there was news.
class HalfTurnTest : public LiveBoxesTest {
 protected:
  HalfTurnTest() {
    Shape cube;
    cube.solid = Solid::kBox;
    cube.size = Eigen::Vector3d(2, 2, 2);
    adopt({"l", {cube}, 0, ""});
  }

  bool send(const std::string& parent, const std::string& child, double stamp,
            const Eigen::Quaterniond& rotation, bool is_static) {
    tf_.add({edge(parent, child, stamp, rotation, {0, 0, 0})}, is_static, now_);
    return scene_.update(now_);
  }

  const Eigen::Quaterniond straight_ = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond half_turn_{0, 0, 0, 1};
};

TEST_F(HalfTurnTest, OfAStaticTransformIsNews) {
  EXPECT_TRUE(send("base", "l", 1, straight_, true));
  const Aabb before = scene_.links.states()[0].box.value();
  EXPECT_TRUE(send("base", "l", 1, half_turn_, true));
  EXPECT_EQ(scene_.links.states()[0].box->min(), before.min());
  EXPECT_EQ(scene_.links.states()[0].box->max(), before.max());
}

TEST_F(HalfTurnTest, BySamplesThatComeLateIsNews) {
  send("base", "m", 1, straight_, false);
  send("base", "m", 3, straight_, false);
  EXPECT_TRUE(send("m", "l", 2, straight_, false));
  EXPECT_TRUE(send("base", "m", 2, half_turn_, false));
  EXPECT_EQ(scene_.links.states()[0].stamp, 2000000000);
}

TEST_F(HalfTurnTest, TheSamePoseAgainIsNoNews) {
  send("base", "l", 1, half_turn_, true);
  EXPECT_FALSE(send("base", "l", 1, half_turn_, true));
  EXPECT_FALSE(send("base", "l", 1, Eigen::Quaterniond(-half_turn_.coeffs()), true));
  EXPECT_FALSE(send("base", "other", 1, straight_, true)) << "another structure, the same pose";
  EXPECT_FALSE(scene_.restart(now_));
}

}  // namespace
}  // namespace link_bounds
