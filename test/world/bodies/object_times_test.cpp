// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Lifetimes, patience and stamps of objects, through reloads and whatever the clock does.
#include "testing/live_objects_testing.h"

namespace link_bounds {
namespace {

const ros::Time kFarAhead(3e9);  // more than a ros::Duration holds

class ObjectTimesTest : public LiveObjectsTest {
 protected:
  void jumpTo(double seconds) {
    now_ = ros::Time(seconds);
    tf_.clear();
    restart();
  }

  void putFor(ObjectContent content, double lifetime) {
    content.lifetime = ros::Duration(lifetime);
    put(content);
  }

  bool isGone() const { return objects_.objects().empty(); }

  double stamp() const { return static_cast<double>(state().stamp) / 1e9; }
};

TEST_F(ObjectTimesTest, AReloadDoesNotBeginALifetimeAnew) {
  for (const ObjectContent& content : {boxIn("tray"), boxIn("camera", 101), boxIn("map", 99)}) {
    putFor(content, 2);
    for (int i = 0; i < 3; ++i) {
      EXPECT_FALSE(isGone()) << content.frame << i;
      adopt("map", 2);
      pass(0.7);
    }
    EXPECT_TRUE(isGone()) << content.frame;
  }
}

TEST_F(ObjectTimesTest, AJumpBackLeavesWhatIsLeftOfALifetime) {
  for (const ObjectContent& content : {boxIn("tray"), boxIn("camera", 101), boxIn("map", 99)}) {
    jumpTo(100);
    putFor(content, 10);
    pass(4);
    jumpTo(50);
    EXPECT_FALSE(pass(1.9));
    jumpTo(0);
    pass(3.9);
    EXPECT_FALSE(isGone()) << content.frame;
    pass(0.3);
    EXPECT_TRUE(isGone()) << content.frame;
  }
}

TEST_F(ObjectTimesTest, ALoopOfTheClockMakesNothingImmortal) {
  putFor(boxIn("map"), 5);
  int loops = 0;
  for (; !isGone() && loops < 100; ++loops) {
    pass(1);
    jumpTo(100);
  }
  EXPECT_EQ(loops, 5);
}

TEST_F(ObjectTimesTest, BeforeTheClockBeginsNoLifetimePasses) {
  now_ = ros::Time();
  jumpTo(0);
  putFor(boxIn("map"), 1);
  pass(0);
  jumpTo(1000);
  EXPECT_FALSE(pass(0.9));
  EXPECT_TRUE(pass(0.2));
}

TEST_F(ObjectTimesTest, AClockFarAheadEndsLifetimesAndPatience) {
  putFor(boxIn("map"), 1);
  objects_.put({"scene", 2}, boxIn("camera", 101), now_);
  objects_.put({"scene", 3}, boxIn("tray"), now_);
  hear("map", "tray", 100, 0);
  now_ = kFarAhead;
  EXPECT_NO_THROW(expire());
  EXPECT_EQ(objects_.objects().count(kKey), 0u);
  EXPECT_EQ(objects_.objects().at({"scene", 2}).problem, TransformProblem::kGivenUp);
  EXPECT_EQ(objects_.objects().at({"scene", 3}).problem, TransformProblem::kStale);
}

TEST_F(ObjectTimesTest, AfterAJumpBackNoStampIsAheadOfTheClock) {
  put(boxIn("map", 99));
  EXPECT_EQ(stamp(), 99);
  jumpTo(10);
  EXPECT_TRUE(state().box) << "it stays";
  EXPECT_EQ(stamp(), 10);
  pass(5);
  EXPECT_FALSE(put(boxIn("map", 99))) << "sent again unchanged";
  EXPECT_EQ(stamp(), 10);
  jumpTo(12);
  EXPECT_EQ(stamp(), 10) << "that is not ahead";
  EXPECT_TRUE(put(boxIn("map", 11)));
  EXPECT_EQ(stamp(), 11);
}

/// Where tf of the new time has it. What the old time sent may still arrive: it stays.
TEST_F(ObjectTimesTest, WhatIsSentAgainAfterAJumpBackIsPlacedAnew) {
  hear("map", "camera", 99, 0, 1);
  put(boxIn("camera", 99));
  expectBox(0, 1);
  jumpTo(10);
  EXPECT_FALSE(put(boxIn("camera", 99))) << "the clock was not there again";
  now_ = ros::Time(99);
  EXPECT_TRUE(put(boxIn("camera", 99)));
  EXPECT_TRUE(state().incomplete) << "it waits for tf";
  hear("map", "camera", 99, 0, 3);
  EXPECT_FALSE(state().incomplete);
  expectBox(0, 3);
  EXPECT_EQ(stamp(), 99);
  EXPECT_FALSE(put(boxIn("camera", 99))) << "it is known now";
  now_ = ros::Time(105);
  jumpTo(100);
  EXPECT_FALSE(put(boxIn("camera", 99))) << "tf will not know that time again";
  expectBox(0, 3);
}

/// A sender repeats its marker with a fixed stamp every 20 s. What cannot be placed anew stays.
TEST_F(ObjectTimesTest, WhatTfForgotOrNeverKnewStaysWhereItWas) {
  for (const double repeated : {100, 130}) {
    now_ = ros::Time(99);
    hear("map", "camera", 99, 0, 1);
    put(boxIn("camera", 99));
    jumpTo(90);
    now_ = ros::Time(repeated);
    hear("map", "camera", repeated, 0, 3);
    EXPECT_EQ(put(boxIn("camera", 99)), repeated == 100) << "tf may still get that time";
    EXPECT_EQ(state().incomplete, repeated == 100);
    pass(2.1);
    EXPECT_FALSE(state().incomplete);
    expectBox(0, 1);
    EXPECT_EQ(object().stamp_time, StampTime::kNotSent);
    objects_.removeAll();
    tf_.clear();
  }
}

/// tf of the new time may have that stamp, too, but it is not the time at which the object was
/// there.
TEST_F(ObjectTimesTest, WhatWaitsDuringAJumpBackIsPlacedOnlyWhenItIsSentAgain) {
  put(boxIn("camera", 99));
  jumpTo(98.9);
  hear("map", "camera", 99, 0, 1);
  EXPECT_TRUE(state().incomplete);
  EXPECT_FALSE(state().box);
  EXPECT_TRUE(put(boxIn("camera", 99)));
  expectBox(0, 1);
}

TEST_F(ObjectTimesTest, WhatIsStaticPlacesAlsoWhatWaitedDuringAJumpBack) {
  put(boxIn("camera", 99));
  jumpTo(98.9);
  tf_.add({edge("map", "camera", 0, turnedBy(0), {1, 0, 0})}, true, now_);
  EXPECT_TRUE(update());
  EXPECT_FALSE(state().incomplete);
  expectBox(0, 1);
}

/// A frame does not move in itself.
TEST_F(ObjectTimesTest, WhatWaitedDuringAJumpBackIsPlacedInTheFrameThatBecomesTheFixedOne) {
  put(boxIn("camera", 99));
  jumpTo(98.9);
  hear("map", "camera", 98.95, 0, 1);
  EXPECT_TRUE(state().incomplete);
  adopt("camera", 2);
  EXPECT_FALSE(state().incomplete);
  expectBox(0, 0);
}

TEST_F(ObjectTimesTest, WhatWaitsToBePlacedAnewHasItsBoxInAnotherFixedFrame) {
  tf_.add({edge("map", "odom", 0, turnedBy(0), {5, 0, 0})}, true, now_);
  hear("map", "camera", 99, 0, 1);
  put(boxIn("camera", 99));
  jumpTo(98.9);
  put(boxIn("camera", 99));
  for (const char* const frame : {"odom", "map"}) {
    adopt(frame, 2);
    EXPECT_TRUE(state().incomplete) << frame;
    expectBox(0, frame == std::string("odom") ? -4 : 1);
  }
  hear("map", "camera", 99, 0, 3);
  EXPECT_FALSE(state().incomplete);
  expectBox(0, 3);
}

TEST_F(ObjectTimesTest, WhatWaitsIsNoNewsWhenItIsSentAgainAfterAJump) {
  put(boxIn("camera", 99));
  jumpTo(98.9);
  EXPECT_FALSE(put(boxIn("camera", 99)));
  hear("map", "camera", 99, 0, 1);
  EXPECT_EQ(stamp(), 99);
  EXPECT_EQ(object().stamp_time, StampTime::kRepeated);
}

TEST_F(ObjectTimesTest, WhatWasGivenUpIsOfTheOldTimeAlsoWhenItIsSentAgain) {
  put(boxIn("camera", 99));
  now_ = ros::Time(100.3);
  jumpTo(99.05);
  pass(2.1);
  ASSERT_EQ(object().problem, TransformProblem::kGivenUp);
  hear("map", "camera", 99, 0, 1);
  EXPECT_TRUE(put(boxIn("camera", 99)));
  EXPECT_FALSE(state().incomplete);
  EXPECT_EQ(object().stamp_time, StampTime::kOutside) << "as far as one can know";
  EXPECT_TRUE(put(boxIn("camera", 99.06)));
  EXPECT_EQ(object().stamp_time, StampTime::kKnown);
}

TEST_F(ObjectTimesTest, WhenTheClockStartsOnlyStampsAheadOfItAreOutdated) {
  now_ = ros::Time();
  put(boxIn("map", 99));
  objects_.put({"scene", 2}, boxIn("map", 98), now_);
  now_ = ros::Time(98.9);
  EXPECT_TRUE(objects_.startClock(now_));
  EXPECT_FALSE(objects_.put({"scene", 2}, boxIn("map", 98), now_));
  EXPECT_EQ(stamp(), 98.9);
  EXPECT_TRUE(put(boxIn("map", 99)));
  EXPECT_EQ(stamp(), 99);
}

TEST_F(ObjectTimesTest, AJumpBackIsNewsWhereItChangesAStamp) {
  put(boxIn("map", 99));
  now_ = ros::Time(10);
  EXPECT_TRUE(restart());
  EXPECT_FALSE(restart());
}

TEST_F(ObjectTimesTest, WhatTheOldEraSentArrivesLate) {
  jumpTo(10);
  put(boxIn("map", 99));
  EXPECT_EQ(stamp(), 10);
  put(boxIn("map", 10.25));
  EXPECT_EQ(stamp(), 10.25) << "a clock that is a little ahead";
  put(boxIn("map", 150));
  EXPECT_EQ(stamp(), 150) << "the clock was never there";
}

TEST_F(ObjectTimesTest, NorIsThatOfABoxThatGoesOn) {
  put(boxIn("map", 99));
  put(boxIn("camera", 101));
  ObjectContent other = boxIn("map", 98);
  objects_.put({"scene", 2}, other, now_);
  objects_.put({"scene", 2}, meshOf("package://a/b.stl"), now_);
  jumpTo(10);
  ASSERT_TRUE(state().box);
  EXPECT_EQ(stamp(), 10);
  ASSERT_TRUE(objects_.objects().at({"scene", 2}).state.box);
  EXPECT_EQ(objects_.objects().at({"scene", 2}).state.stamp, 10'000'000'000);
}

}  // namespace
}  // namespace link_bounds
