// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects that were placed once, when another frame becomes the fixed frame.

#include "testing/live_objects_testing.h"
#include "testing/numbers.h"

namespace link_bounds {
namespace {

/// The fixed frame is base at first; later odom, in which base is at x = 100.
class ObjectFramesTest : public LiveObjectsTest {
 protected:
  ObjectFramesTest() { adopt("base"); }

  void adopt(const std::string& fixed_frame) { LiveObjectsTest::adopt(fixed_frame, 2); }

  /// Placed in base at x = 2, too long ago for tf to know how base was in odom then.
  void putCube() {
    ObjectContent cube = boxIn("base", 50);
    cube.bounded.shapes.front().size = {1, 1, 1};
    cube.bounded.shapes.front().link_from_shape.translation().x() = 2;
    put(cube);
    expectX(1.5, 2.5);
  }

  void hearOdom(double x = 100) { hear("odom", "base", now_.toSec(), 0, x); }

  void expectX(double min, double max) const {
    ASSERT_TRUE(state().box);
    EXPECT_NEAR(state().box->min().x(), min, kTolerance);
    EXPECT_NEAR(state().box->max().x(), max, kTolerance);
    EXPECT_FALSE(state().incomplete);
  }

  void expectNoBox(TransformProblem problem) const {
    EXPECT_FALSE(state().box);
    EXPECT_TRUE(state().incomplete);
    EXPECT_EQ(object().problem, problem) << objects_.reason(object());
  }
};

TEST_F(ObjectFramesTest, CarriedOverByTheTransformBetweenTheFixedFrames) {
  hearOdom();
  putCube();
  adopt("odom");
  expectX(101.5, 102.5);
  EXPECT_EQ(state().stamp, 50'000'000'000);
}

TEST_F(ObjectFramesTest, OnceCarriedOverItStays) {
  hearOdom();
  putCube();
  adopt("odom");
  pass(1);
  EXPECT_FALSE(hear("odom", "base", 101, 0, 200));
  expectX(101.5, 102.5);
  adopt("odom");
  expectX(101.5, 102.5);
}

TEST_F(ObjectFramesTest, BackInTheFirstFrameTheBoxIsTheSame) {
  hear("odom", "base", 100, 30, 100);
  putCube();
  const Aabb before = *state().box;
  adopt("odom");
  hear("odom", "base", 101, 45, 200);
  adopt("base");
  EXPECT_TRUE(isSame(*state().box, before));
}

TEST_F(ObjectFramesTest, WithoutATransformThereIsNoBoxAtOnceAndNothingIsGivenUp) {
  putCube();
  adopt("odom");
  expectNoBox(TransformProblem::kNotCarried);
  EXPECT_NE(objects_.reason(object()).find("\"base\""), std::string::npos)
      << objects_.reason(object());
  pass(1000);
  expectNoBox(TransformProblem::kNotCarried);
  EXPECT_TRUE(objects_.takeGivenUp().empty());
  hearOdom();
  expectX(101.5, 102.5);
}

TEST_F(ObjectFramesTest, BackInTheFirstFrameNoTransformIsNeeded) {
  putCube();
  adopt("odom");
  adopt("base");
  expectX(1.5, 2.5);
}

TEST_F(ObjectFramesTest, FromFrameToFrameByTheFirstOne) {
  putCube();
  adopt("nowhere");
  hear("map", "base", 100, 0, 7);
  adopt("map");
  expectX(8.5, 9.5);
  pass(1);
  hearOdom();
  adopt("odom");
  expectX(101.5, 102.5);
}

TEST_F(ObjectFramesTest, ATransformThatIsStaleOrNotFiniteIsWaitedFor) {
  hearOdom(50);
  putCube();
  pass(2.5);
  adopt("odom");
  expectNoBox(TransformProblem::kNotCarried);
  hearOdom(kInfinity);
  expectNoBox(TransformProblem::kNotCarried);
  pass(1);
  hearOdom();
  expectX(101.5, 102.5);
}

TEST_F(ObjectFramesTest, AClockJumpTakesNothingAway) {
  putCube();
  adopt("odom");
  now_ = ros::Time(10);
  tf_.clear();
  restart();
  expectNoBox(TransformProblem::kNotCarried);
  hearOdom();
  expectX(101.5, 102.5);
  now_ = ros::Time(5);
  tf_.clear();
  restart();
  expectX(101.5, 102.5);
}

TEST_F(ObjectFramesTest, AStaticWayThatAClockJumpFreesOfALoopCarriesOverAtOnce) {
  tf_.add({edge("base", "cam", 0, turnedBy(0), {-100, 0, 0})}, true, now_);
  hear("base", "loop", 100, 0);
  hear("loop", "base", 100, 0);
  putCube();
  adopt("cam");
  expectNoBox(TransformProblem::kNotCarried);
  tf_.clear();
  now_ = ros::Time(60);
  EXPECT_TRUE(restart());
  expectX(101.5, 102.5);
}

TEST_F(ObjectFramesTest, WhatWaitsForItsFirstTransformWaitsOn) {
  hearOdom();
  put(boxIn("camera", 100.5));
  pass(1.5);
  adopt("odom");
  EXPECT_EQ(object().problem, TransformProblem::kWaiting);
  EXPECT_FALSE(pass(1.5)) << "its patience begins anew";
  hear("odom", "camera", 100, 0, 7);
  hear("odom", "camera", 101, 0, 7);
  expectX(6.5, 7.5);
}

TEST_F(ObjectFramesTest, WhatWasGivenUpIsTriedInTheNewFrame) {
  put(boxIn("camera", 100));
  pass(2.5);
  expectNoBox(TransformProblem::kGivenUp);
  hear("odom", "camera", 100, 0, 7);
  adopt("odom");
  expectX(6.5, 7.5);
}

// While new content waits, the previous box goes on, but not under the name of another frame.
TEST_F(ObjectFramesTest, APreviousBoxDoesNotOutliveItsFrame) {
  hearOdom();
  putCube();
  put(boxIn("camera", 101));
  EXPECT_TRUE(state().box);
  adopt("odom");
  expectNoBox(TransformProblem::kWaiting);
  adopt("base");
  putCube();
  ObjectContent mesh = meshOf("package://a/b.stl");
  mesh.frame = "base";
  put(mesh);
  EXPECT_TRUE(state().box);
  adopt("odom");
  EXPECT_FALSE(state().box);
  EXPECT_TRUE(state().incomplete);
}

}  // namespace
}  // namespace link_bounds
