// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of other nodes become objects, come and go with the messages, and grow old.
#include "testing/neighbours_testing.h"

namespace link_bounds {
namespace {

TEST_F(NeighboursTest, InTheFixedFrameTheBoxesAreTheSame) {
  EXPECT_TRUE(take(arrayOf("map", {boxAround("arm", {0.1, 0.7, 9.3}, 99)})));
  const BoxState& state = arm().state;
  ASSERT_TRUE(state.box);
  EXPECT_FALSE(state.incomplete);
  EXPECT_EQ(state.stamp, 99'000'000'000);
  const AxisAlignedBox sent = boxAround("arm", {0.1, 0.7, 9.3}, 99);
  const Eigen::Vector3d min(sent.min.x, sent.min.y, sent.min.z);
  const Eigen::Vector3d max(sent.max.x, sent.max.y, sent.max.z);
  EXPECT_TRUE((state.box->min().array() <= min.array()).all());
  EXPECT_TRUE((state.box->max().array() >= max.array()).all());
  EXPECT_LT((state.box->min() - min).norm() + (state.box->max() - max).norm(), kTolerance);
  EXPECT_FALSE(take(arrayOf("map", {sent}))) << "nothing is new";
}

TEST_F(NeighboursTest, InAnotherFrameItIsTheBoxOfTheBoxAndHasTheOlderStamp) {
  take(arrayOf("base", {boxAround("arm", {0, 0, 0}, 99)}));
  EXPECT_FALSE(arm().state.box);
  EXPECT_TRUE(arm().state.incomplete);
  hear("map", "base", 98, 30, 5);
  ASSERT_TRUE(arm().state.box);
  const Eigen::Vector3d radius =
      turnedBy(30).toRotationMatrix().cwiseAbs() * Eigen::Vector3d(1, 2, 3);
  EXPECT_LT((arm().state.box->max() - radius - Eigen::Vector3d(5, 0, 0)).norm(), kTolerance);
  EXPECT_EQ(arm().state.stamp, 98'000'000'000);
  hear("map", "base", 100, 30, 6);
  EXPECT_EQ(arm().state.stamp, 99'000'000'000) << "the box is no newer than its message";
  take(arrayOf("base", {boxAround("arm", {0, 0, 0}, 0)}));
  EXPECT_EQ(arm().state.stamp, 100'000'000'000) << "a static box has the stamp of its frame";
}

TEST_F(NeighboursTest, ABoxThatIsNotInTheNewestMessageIsGone) {
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99), boxAround("hand", {0, 0, 0}, 99)}));
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)}), "/left/bounds");
  EXPECT_EQ(names(),
            (std::set<std::string>{"/right/bounds/arm", "/right/bounds/hand", "/left/bounds/arm"}));
  EXPECT_TRUE(take(arrayOf("map", {boxAround("hand", {0, 0, 0}, 99)})));
  EXPECT_EQ(names(), (std::set<std::string>{"/right/bounds/hand", "/left/bounds/arm"}));
  EXPECT_TRUE(take(arrayOf("map", {})));
  EXPECT_EQ(names(), std::set<std::string>{"/left/bounds/arm"});
}

TEST_F(NeighboursTest, WhatIsIncompleteAtItsSenderIsIncompleteHere) {
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)}, {"arm", "hand"}));
  EXPECT_TRUE(arm().state.box);
  EXPECT_TRUE(arm().state.incomplete);
  const LiveObject& hand = *find("/right/bounds/hand");
  EXPECT_FALSE(hand.state.box);
  EXPECT_TRUE(hand.state.incomplete);
  EXPECT_EQ(objects_.reason(hand), "it is incomplete at /right/bounds");
}

TEST_F(NeighboursTest, WhatTheSenderHasFromItsNeighboursIsLeftOut) {
  take(arrayOf("map",
               {boxAround("arm", {0, 0, 0}, 99), boxAround("held/1", {0, 0, 0}, 99),
                boxAround("/left/bounds/arm", {0, 0, 0}, 99)},
               {"/left/bounds/hand"}));
  EXPECT_EQ(names(), (std::set<std::string>{"/right/bounds/arm", "/right/bounds/held/1"}));
}

TEST_F(NeighboursTest, SeveralBoxesOfOneNameAreOneAroundThem) {
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99), boxAround("arm", {5, 0, 0}, 98),
                       boxAround("arm", {2, 0, 9}, 0)}));
  EXPECT_LT((arm().state.box->min() - Eigen::Vector3d(-1, -2, -3)).norm(), kTolerance);
  EXPECT_LT((arm().state.box->max() - Eigen::Vector3d(6, 2, 12)).norm(), kTolerance);
  EXPECT_EQ(arm().state.stamp, 98'000'000'000);
}

TEST_F(NeighboursTest, BadBoxesAreRefusedWithAReason) {
  const auto expect = [this](const AxisAlignedBoxArray& array, const std::string& begin) {
    take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)}));
    EXPECT_FALSE(arm().state.incomplete);
    EXPECT_TRUE(take(array));
    EXPECT_FALSE(arm().state.box);
    EXPECT_TRUE(arm().state.incomplete);
    EXPECT_EQ(objects_.reason(arm()).rfind(begin, 0), 0u) << objects_.reason(arm());
  };
  expect(arrayOf("map", {boxAround("arm", {0, kNan, 0}, 99)}), "min or max has a number");
  expect(arrayOf("map", {boxAround("arm", {0, 0, 1e30}, 99)}), "min or max has a number");
  AxisAlignedBox box = boxAround("arm", {0, 0, 0}, 99);
  std::swap(box.min.y, box.max.y);
  expect(arrayOf("map", {box}), "min is greater than max");
  box = boxAround("arm", {0, 0, 0}, 99);
  box.stamp.sec = UINT32_MAX;
  expect(arrayOf("map", {box}), "its stamp is no time");
  expect(arrayOf("", {boxAround("arm", {0, 0, 0}, 99)}), "header.frame_id is empty");
}

TEST_F(NeighboursTest, InAFrameThatTfDoesNotConnectThereIsNoBox) {
  EXPECT_TRUE(take(arrayOf("nowhere", {boxAround("arm", {0, 0, 0}, 99)})));
  EXPECT_FALSE(arm().state.box);
  EXPECT_TRUE(arm().state.incomplete);
  EXPECT_EQ(objects_.reason(arm()).rfind("no transform", 0), 0u) << objects_.reason(arm());
}

TEST_F(NeighboursTest, ASilentSenderHasNoBoxes) {
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99), boxAround("base", {0, 0, 0}, 0)}));
  EXPECT_FALSE(pass(1.9));
  EXPECT_TRUE(pass(0.2));
  EXPECT_FALSE(arm().state.box);
  EXPECT_TRUE(arm().state.incomplete);
  EXPECT_EQ(objects_.reason(arm()), "/right/bounds has sent no boxes for longer than timeout");
  EXPECT_TRUE(find("/right/bounds/base")->state.box) << "it is static";
  EXPECT_FALSE(pass(10));
  EXPECT_TRUE(take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)})));
  EXPECT_TRUE(arm().state.box);
  EXPECT_FALSE(arm().state.incomplete);
  pass(3);
  adopt("map", 2);
  EXPECT_TRUE(names().empty()) << "a ~reload forgets it";
  adopt("map", 0);
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)}));
  EXPECT_FALSE(pass(1000));
}

TEST_F(NeighboursTest, AgesBeginAnewAndNoStampIsAheadAfterAJumpBack) {
  take(arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)}));
  now_ = ros::Time(10);
  restart();
  EXPECT_EQ(arm().state.stamp, 10'000'000'000);
  EXPECT_FALSE(pass(1.9));
  EXPECT_TRUE(pass(0.2));
}

}  // namespace
}  // namespace link_bounds
