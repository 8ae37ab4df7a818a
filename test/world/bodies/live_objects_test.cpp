// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects appear, follow their frames, wait, grow old and go.
#include "testing/live_objects_testing.h"

namespace link_bounds {
namespace {

TEST_F(LiveObjectsTest, InTheFixedFrameNeedsNoTransform) {
  EXPECT_TRUE(put(boxIn("map")));
  expectBox(0);
  EXPECT_FALSE(state().incomplete);
  EXPECT_EQ(state().stamp, 0);
}

TEST_F(LiveObjectsTest, WithoutAFixedFrameItIsKept) {
  FrameTracker frames(tf_);
  LiveObjects objects(frames);
  objects.put(kKey, boxIn("map"), now_);
  EXPECT_FALSE(objects.objects().at(kKey).state.box);
  frames.setTarget("map", 2, now_);
  objects.adopt(now_);
  EXPECT_TRUE(objects.objects().at(kKey).state.box);
}

TEST_F(LiveObjectsTest, FollowsItsFrame) {
  EXPECT_TRUE(put(boxIn("tray")));
  EXPECT_FALSE(state().box);
  EXPECT_TRUE(state().incomplete);
  EXPECT_TRUE(hear("map", "tray", 99, 30, 5));
  expectBox(30, 5);
  EXPECT_EQ(state().stamp, 99'000'000'000);
  EXPECT_TRUE(hear("map", "tray", 100, 45, 6));
  expectBox(45, 6);
  EXPECT_FALSE(hear("map", "other", 100, 45, 6));
}

TEST_F(LiveObjectsTest, APoseThatLeavesTheBoxAsItWasIsNews) {
  const auto send = [this](double x_of_quaternion) {
    const Eigen::Quaterniond turn(1 - x_of_quaternion, x_of_quaternion, 0, 0);
    tf_.add({edge("map", "tray", 1, turn, {0, 0, 0})}, true, now_);
    return update();
  };
  put(boxIn("tray"));
  EXPECT_TRUE(send(0));
  EXPECT_TRUE(send(1));
  expectBox(0);
  EXPECT_FALSE(send(1));
}

// The newest parent decides about the time, and at that time the parent was the one before.
TEST_F(LiveObjectsTest, LateNewsOfAnOldParentAreNews) {
  put(boxIn("tray"));
  hear("map", "old", 98, 0, 1);
  hear("old", "tray", 98, 30, 1);
  hear("map", "new", 99, 0, 7);
  hear("new", "tray", 100, 30, 1);
  EXPECT_FALSE(state().box);
  EXPECT_TRUE(hear("map", "old", 100, 0, 3));
  EXPECT_EQ(state().stamp, 99'000'000'000);
  expectBox(30, 3);
}

TEST_F(LiveObjectsTest, FollowsThroughReparenting) {
  put(boxIn("tray"));
  hear("map", "tray", 99, 30, 5);
  hear("map", "gripper", 99.5, 0, 1);
  EXPECT_TRUE(hear("gripper", "tray", 99.5, 30, 1));
  expectBox(30, 2);
}

TEST_F(LiveObjectsTest, APathThatIsCutTakesTheBoxAway) {
  put(boxIn("tray"));
  hear("map", "tray", 99, 30, 5);
  EXPECT_TRUE(hear("elsewhere", "tray", 99.5, 30, 5));
  EXPECT_FALSE(state().box);
  EXPECT_EQ(object().problem, TransformProblem::kNoTransform);
}

TEST_F(LiveObjectsTest, ASilentFrameIsStale) {
  put(boxIn("tray"));
  hear("map", "tray", 100, 30);
  EXPECT_FALSE(pass(1.9));
  EXPECT_TRUE(pass(0.2));
  EXPECT_FALSE(state().box);
  EXPECT_TRUE(state().incomplete);
  EXPECT_EQ(object().problem, TransformProblem::kStale);
  EXPECT_TRUE(hear("map", "tray", 102, 45));
  expectBox(45);
}

TEST_F(LiveObjectsTest, PlacedOnceByTheTransformAtItsStampAndStays) {
  hear("map", "camera", 99, 30, 0);
  EXPECT_TRUE(put(boxIn("camera", 99.5)));
  EXPECT_EQ(object().problem, TransformProblem::kWaiting);
  EXPECT_TRUE(state().incomplete);
  EXPECT_TRUE(hear("map", "camera", 100, 30, 1));
  expectBox(30, 0.5);
  EXPECT_EQ(state().stamp, 99'500'000'000);
  EXPECT_FALSE(hear("map", "camera", 101, 45, 7));
  expectBox(30, 0.5);
  EXPECT_FALSE(pass(100)) << "it never becomes stale";
}

TEST_F(LiveObjectsTest, TheBoxOfBeforeGoesOnUntilTheNewOneCanBePlaced) {
  hear("map", "camera", 99, 30, 0);
  put(boxIn("camera", 99));
  EXPECT_TRUE(put(boxIn("camera", 99.5)));
  expectBox(30, 0);
  EXPECT_TRUE(state().incomplete);
  hear("map", "camera", 100, 30, 1);
  expectBox(30, 0.5);
  EXPECT_FALSE(state().incomplete);
}

TEST_F(LiveObjectsTest, WaitingEndsAfterTheTimeout) {
  hear("map", "camera", 99, 30, 0);
  put(boxIn("camera", 99));
  put(boxIn("camera", 101));
  EXPECT_FALSE(pass(1.9));
  EXPECT_TRUE(pass(0.2));
  EXPECT_FALSE(state().box) << "the box of before is not the object's any more";
  EXPECT_TRUE(state().incomplete);
  EXPECT_EQ(object().problem, TransformProblem::kGivenUp);
  EXPECT_FALSE(hear("map", "camera", 102, 30, 1));
  EXPECT_TRUE(put(boxIn("camera", 101))) << "sent again, it is tried again";
  EXPECT_TRUE(state().box);
}

TEST_F(LiveObjectsTest, WaitingLastsTenSecondsWhereNothingBecomesStale) {
  adopt("map", 0);
  put(boxIn("camera", 99));
  EXPECT_FALSE(pass(9.9));
  EXPECT_TRUE(pass(0.2));
  EXPECT_EQ(object().problem, TransformProblem::kGivenUp);
}

TEST_F(LiveObjectsTest, IsNeverPlacedIfItsStampsStayAheadOfTf) {
  hear("map", "camera", 100, 30, 1);
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(objects_.neverPlaced(now_).size(), i > 20 ? 1u : 0u) << i;
    put(boxIn("camera", now_.toSec() + 5));
    hear("map", "camera", now_.toSec(), 30, 1);
    pass(0.1);
  }
  EXPECT_EQ(object().problem, TransformProblem::kWaiting);
  EXPECT_EQ(objects_.neverPlaced(now_).front().object, &object());
  EXPECT_NEAR(objects_.neverPlaced(now_).front().ahead, 5, 1e-6);
  hear("map", "camera", now_.toSec() + 6, 30, 1);
  EXPECT_TRUE(objects_.neverPlaced(now_).empty()) << "it has been placed";
}

TEST_F(LiveObjectsTest, IsPlacedIfTfOvertakesItsStampsNowAndThen) {
  for (int i = 0; i < 50; ++i) {
    put(boxIn("camera", now_.toSec()));
    EXPECT_EQ(object().problem, TransformProblem::kWaiting);
    EXPECT_TRUE(objects_.neverPlaced(now_).empty()) << i;
    pass(0.1);
    if (i % 5 == 4) hear("map", "camera", now_.toSec() - 0.05, 30, 1);
  }
}

TEST_F(LiveObjectsTest, SaysNothingOfStampsInAFrameThatTfDoesNotConnect) {
  for (int i = 0; i < 50; ++i) {
    put(boxIn("nowhere", now_.toSec() + 5));
    EXPECT_TRUE(objects_.neverPlaced(now_).empty());
    pass(0.1);
  }
}

TEST_F(LiveObjectsTest, LifetimeCountsFromTheLastReceipt) {
  ObjectContent content = boxIn("map");
  content.lifetime = ros::Duration(1);
  put(content);
  EXPECT_FALSE(pass(0.9));
  EXPECT_FALSE(put(content)) << "nothing changes but its age";
  EXPECT_FALSE(pass(0.9));
  EXPECT_TRUE(pass(0.2));
  EXPECT_TRUE(objects_.objects().empty());
}

TEST_F(LiveObjectsTest, AgesBeginAnewAfterAJumpBack) {
  ObjectContent content = boxIn("map");
  content.lifetime = ros::Duration(1);
  put(content);
  now_ = ros::Time(10);
  restart();
  EXPECT_FALSE(pass(0.9));
  EXPECT_TRUE(pass(0.2));
}

/// Points of a marker, in memory of their own each time.
ObjectContent sheet(double height) {
  const auto points = std::make_shared<std::vector<double>>(
      std::vector<double>{0, 0, height, 1, 0, height, 0, 1, height});
  ObjectContent content = boxIn("map");
  Shape& shape = content.bounded.shapes.front();
  shape.solid = Solid::kNone;
  shape.points =
      std::make_shared<const PointSet>(std::shared_ptr<const double>(points, points->data()), 3);
  return content;
}

TEST_F(LiveObjectsTest, UnchangedPointsAreNotScannedAgain) {
  EXPECT_TRUE(put(sheet(1)));
  const PointSet* first = object().content->bounded.shapes.front().points.get();
  EXPECT_FALSE(put(sheet(1)));
  EXPECT_EQ(object().content->bounded.shapes.front().points.get(), first);
  EXPECT_TRUE(put(sheet(2)));
  EXPECT_NEAR(state().box->max().z(), 2, kTolerance);
}

TEST_F(LiveObjectsTest, AMeshIsWaitedForAndKeepsTheBoxOfBefore) {
  put(boxIn("map"));
  EXPECT_TRUE(put(meshOf("package://a/b.stl")));
  expectBox(0);
  EXPECT_TRUE(state().incomplete);
  const LoadedMesh mesh = loadedMesh();
  EXPECT_FALSE(objects_.fillMesh("package://a/other.stl", mesh, now_));
  EXPECT_TRUE(objects_.fillMesh("package://a/b.stl", mesh, now_));
  EXPECT_FALSE(state().incomplete);
  EXPECT_LT(state().box->sizes().maxCoeff(), 1.1);
}

TEST_F(LiveObjectsTest, AnotherBodyInTheSameBoxIsNews) {
  ObjectContent content = boxIn("map");
  put(content);
  content.bounded.shapes.front().solid = Solid::kEllipsoid;
  EXPECT_TRUE(put(content));
  EXPECT_FALSE(put(content));
  expectBox(0);
}

TEST_F(LiveObjectsTest, AnotherMeshOfTheSameExtentsIsNews) {
  const auto mesh = [](float x) {
    const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}, {x, 1, 1}};
    return LoadedMesh{std::make_shared<const PointSet>(points), ""};
  };
  put(meshOf("package://a/b.stl"));
  EXPECT_TRUE(objects_.fillMesh("package://a/b.stl", mesh(0), now_));
  const Aabb before = *state().box;
  EXPECT_TRUE(objects_.fillMesh("package://a/b.stl", mesh(1), now_));
  EXPECT_TRUE(isSame(*state().box, before));
}

TEST_F(LiveObjectsTest, ANewStampOfANeighbourInAnOldPoseIsNoNews) {
  hear("map", "tray", 90, 0);
  ObjectContent content = boxIn("tray", 99);
  content.is_neighbour = true;
  put(content);
  content.stamp += 1;
  EXPECT_FALSE(put(content));
}

TEST_F(LiveObjectsTest, AMeshThatCannotBeUsedTakesTheBoxAway) {
  put(boxIn("map"));
  put(meshOf("package://a/b.stl"));
  EXPECT_TRUE(objects_.fillMesh("package://a/b.stl", {nullptr, "broken"}, now_));
  EXPECT_FALSE(state().box);
  EXPECT_TRUE(state().incomplete);
  EXPECT_EQ(objects_.reason(object()), "broken");
}

TEST_F(LiveObjectsTest, ANewFixedFrameMovesAllBoxes) {
  hear("map", "camera", 99, 30, 1);
  put(boxIn("map"));
  objects_.put({"scene", 2}, boxIn("camera", 99), now_);
  adopt("camera", 2);
  const Eigen::Vector3d center = state().box->center();
  EXPECT_LT((center - turnedBy(-30) * Eigen::Vector3d(-1, 0, 0)).norm(), kTolerance);
  EXPECT_LT(objects_.objects().at({"scene", 2}).state.box->center().norm(), kTolerance);
}

TEST_F(LiveObjectsTest, APoseThatIsNotFiniteHasNoBox) {
  hear("map", "tray", 99, 0, 1e300);
  ObjectContent content = boxIn("tray");
  content.bounded.shapes.front().link_from_shape.translation().x() = 1.7e308;
  put(content);
  hear("map", "tray", 100, 0, 1.7e308);
  EXPECT_FALSE(state().box);
  EXPECT_EQ(object().problem, TransformProblem::kPoseNotFinite);
}

TEST_F(LiveObjectsTest, AThousandThatWaitAndGoLeaveNothingBehind) {
  for (int i = 0; i < 1000; ++i)
    objects_.put({"many", i}, boxIn(i % 2 ? "camera" : "tray", i % 3 ? 99 : 0), now_);
  for (int i = 0; i < 1000; i += 2)
    EXPECT_TRUE(objects_.remove({"many", i}));
  EXPECT_FALSE(objects_.remove({"many", 0}));
  for (int i = 1; i < 1000; i += 2)
    objects_.put({"many", i}, boxIn("map"), now_);
  EXPECT_FALSE(hear("map", "camera", 99, 30)) << "nobody waits for it any more";
  EXPECT_TRUE(objects_.removeAll());
  EXPECT_FALSE(objects_.removeAll());
  EXPECT_FALSE(pass(100));
}

}  // namespace
}  // namespace link_bounds
