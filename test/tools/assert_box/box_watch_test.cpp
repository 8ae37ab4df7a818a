// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What assert_box demands and what it tells, without ROS running.
#include "tools/assert_box/box_watch.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <limits>

#include "node/parameters/parameter_reader.h"
#include "tools/assert_box/box_condition.h"
#include "tools/assert_box/test_report.h"

namespace link_bounds {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTolerance = 1e-3;  // m
constexpr double kRounding = 1e-12;  // m

const Aabb kWanted(Eigen::Vector3d(-1, -2, 0), Eigen::Vector3d(1, 2, 3));

Aabb moved(const Aabb& box, double x, double y, double z) {
  return Aabb(box).translate(Eigen::Vector3d(x, y, z));
}

/// Each side of kWanted further out by `metres`, or further in.
Aabb grown(double metres) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(metres);
  return Aabb(kWanted.min() - margin, kWanted.max() + margin);
}

/// The box of a cube of 1 m that is turned by 30 degrees about z.
Aabb turnedCube() {
  const double half = (std::cos(M_PI / 6) + std::sin(M_PI / 6)) / 2;
  return Aabb(Eigen::Vector3d(-half, -half, 1), Eigen::Vector3d(half, half, 2));
}

bool keeps(BoxCheck check, const Aabb& box, const Aabb& wanted = kWanted) {
  return isSatisfied({check, wanted, kTolerance}, {box});
}

TEST(BoxCondition, EqualComparesEachCoordinate) {
  EXPECT_TRUE(keeps(BoxCheck::kEqual, kWanted));
  for (int i = 0; i < 6; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      Aabb near = kWanted;
      Aabb far = kWanted;
      (i < 3 ? near.min() : near.max())[i % 3] += sign * 0.9 * kTolerance;
      (i < 3 ? far.min() : far.max())[i % 3] += sign * 1.1 * kTolerance;
      EXPECT_TRUE(keeps(BoxCheck::kEqual, near)) << i;
      EXPECT_FALSE(keeps(BoxCheck::kEqual, far)) << i;
      EXPECT_NEAR(excess({BoxCheck::kEqual, kWanted, 0}, far), 1.1 * kTolerance, kRounding);
    }
  }
}

TEST(BoxCondition, InsideGrowsTheZoneByTheTolerance) {
  EXPECT_TRUE(keeps(BoxCheck::kInside, turnedCube()));
  EXPECT_TRUE(keeps(BoxCheck::kInside, grown(0.9 * kTolerance)));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d step = sign * 1.1 * kTolerance * Eigen::Vector3d::Unit(axis);
      const Aabb out = moved(kWanted, step.x(), step.y(), step.z());
      EXPECT_FALSE(keeps(BoxCheck::kInside, out)) << axis;
      EXPECT_NEAR(excess({BoxCheck::kInside, kWanted, 0}, out), 1.1 * kTolerance, kRounding);
    }
  }
}

TEST(BoxCondition, OutsideNeedsOneAxisWithoutOverlap) {
  const Aabb cube = turnedCube();
  const double touching = 1 + cube.max().x();  // m along x
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(keeps(BoxCheck::kOutside, moved(cube, sign * touching, 0, 0)));
    EXPECT_TRUE(keeps(BoxCheck::kOutside, moved(cube, sign * (touching - 0.9e-3), 0, 0)));
    EXPECT_FALSE(keeps(BoxCheck::kOutside, moved(cube, sign * (touching - 1.1e-3), 0, 0)));
  }
  EXPECT_TRUE(keeps(BoxCheck::kOutside, moved(cube, 0, 0, 2)));
  EXPECT_FALSE(keeps(BoxCheck::kOutside, cube));
}

TEST(BoxCondition, AFlatBoxAcrossTheZoneIsNotOutside) {
  const Aabb sheet(Eigen::Vector3d(-5, -5, 1), Eigen::Vector3d(5, 5, 1));
  EXPECT_FALSE(keeps(BoxCheck::kOutside, sheet));
}

TEST(BoxCondition, ABoxPartlyInsideIsNeither) {
  const Aabb partly = moved(turnedCube(), 1, 0, 0);
  EXPECT_FALSE(keeps(BoxCheck::kInside, partly));
  EXPECT_FALSE(keeps(BoxCheck::kOutside, partly));
}

TEST(BoxCondition, AnInfiniteSideIsNoLimit) {
  const Aabb half_space(Eigen::Vector3d(-kInfinity, -kInfinity, 0),
                        Eigen::Vector3d(kInfinity, kInfinity, kInfinity));
  EXPECT_TRUE(keeps(BoxCheck::kInside, turnedCube(), half_space));
  EXPECT_FALSE(keeps(BoxCheck::kInside, moved(turnedCube(), 0, 0, -1.5), half_space));
  EXPECT_TRUE(keeps(BoxCheck::kOutside, moved(turnedCube(), 0, 0, -2), half_space));
  EXPECT_FALSE(keeps(BoxCheck::kOutside, turnedCube(), half_space));
}

TEST(BoxCondition, WhatIsNoBoxKeepsNothing) {
  Aabb not_a_number = kWanted;
  not_a_number.max().y() = kNaN;
  Aabb inverted = moved(kWanted, 10, 0, 0);
  std::swap(inverted.min().x(), inverted.max().x());
  for (const BoxCheck check : {BoxCheck::kEqual, BoxCheck::kInside, BoxCheck::kOutside}) {
    EXPECT_FALSE(keeps(check, not_a_number));
    EXPECT_FALSE(keeps(check, inverted));
  }
}

TEST(BoxCondition, AllOfSeveralBoxesMustKeepIt) {
  const BoxCondition inside{BoxCheck::kInside, kWanted, 0};
  EXPECT_TRUE(isSatisfied(inside, {turnedCube(), kWanted}));
  EXPECT_FALSE(isSatisfied(inside, {turnedCube(), moved(kWanted, 0, 1, 0)}));
  EXPECT_FALSE(isSatisfied(inside, {}));
}

TEST(Hold, ABreakBeginsItAnew) {
  Hold hold(2.0);
  EXPECT_FALSE(hold.isKept(0));
  hold.update(true, 1.0);
  hold.update(true, 2.0);
  EXPECT_FALSE(hold.isKept(2.9));
  hold.update(false, 2.9);
  EXPECT_FALSE(hold.isKept(4.0));
  hold.update(true, 5.0);
  EXPECT_FALSE(hold.isKept(6.9));
  EXPECT_DOUBLE_EQ(hold.longest(6.0), 1.9);
  EXPECT_TRUE(hold.isKept(7.0));
}

TEST(Hold, OfNoLengthIsKeptAtOnce) {
  Hold hold(0.0);
  EXPECT_FALSE(hold.isKept(1.0));
  hold.update(true, 1.0);
  EXPECT_TRUE(hold.isKept(1.0));
}

TEST(Hold, StaysKeptWhateverComesAfterIt) {
  Hold at_once(0.0);
  at_once.update(true, 1.0);
  at_once.update(false, 1.0);
  EXPECT_TRUE(at_once.isKept(1.0));
  Hold hold(2.0);
  hold.update(true, 1.0);
  hold.update(false, 3.0);
  hold.update(true, 3.5);
  EXPECT_TRUE(hold.isKept(3.6));
}

AssertBoxParameters palmInside() {
  AssertBoxParameters parameters;
  parameters.name = "palm";
  parameters.min = {-1.0, -2.0, 0.0};
  parameters.max = {1.0, 2.0, 3.0};
  parameters.check = "inside";
  parameters.hold = 1.0;
  return parameters;
}

using Change = void (*)(AssertBoxParameters&);

TEST(AssertBoxParameters, AreCheckedTogether) {
  EXPECT_NO_THROW(boxAssertion(palmInside()));
  const std::pair<Change, const char*> faults[] = {
      {[](AssertBoxParameters& p) { p.name.reset(); }, "~name is required"},
      {[](AssertBoxParameters& p) { p.min.reset(); }, "~min is required"},
      {[](AssertBoxParameters& p) { p.max.reset(); }, "~max is required"},
      {[](AssertBoxParameters& p) {
         p.min = {0.0, 2.1, 0.0};
       },
       "~min must not be greater"},
      {[](AssertBoxParameters& p) { p.hold = p.deadline; }, "~hold must be less than ~deadline"},
      {[](AssertBoxParameters& p) {
         p.check = "equal";
         p.max = {1.0, 2.0, kInfinity};
       },
       "must be finite"}};
  for (const auto& [change, text] : faults) {
    AssertBoxParameters parameters = palmInside();
    change(parameters);
    try {
      boxAssertion(parameters);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const ParameterError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  }
}

AxisAlignedBoxArray::Ptr messageOf(const std::string& name, const Aabb& box) {
  auto message = boost::make_shared<AxisAlignedBoxArray>();
  message->header.frame_id = "world";
  message->boxes.resize(1);
  message->boxes[0].name = name;
  message->boxes[0].min.x = box.min().x();
  message->boxes[0].min.y = box.min().y();
  message->boxes[0].min.z = box.min().z();
  message->boxes[0].max.x = box.max().x();
  message->boxes[0].max.y = box.max().y();
  message->boxes[0].max.z = box.max().z();
  return message;
}

class BoxWatchTest : public testing::Test {
 protected:
  BoxWatch watch_{boxAssertion(palmInside())};  // hold: 1 s
};

TEST_F(BoxWatchTest, PassesAfterTheHoldWithoutFurtherMessages) {
  watch_.see(messageOf("palm", turnedCube()), 1.0);
  EXPECT_FALSE(watch_.isPassed(1.9));
  EXPECT_TRUE(watch_.isPassed(2.0));
}

/// The watch is asked only after all messages that wait have been seen.
TEST_F(BoxWatchTest, PassesThoughTheBreakCameBeforeItWasAsked) {
  watch_.see(messageOf("palm", turnedCube()), 1.0);
  watch_.see(messageOf("palm", turnedCube()), 2.5);
  watch_.see(messageOf("thumb", turnedCube()), 2.5);
  EXPECT_TRUE(watch_.isPassed(2.5));
  EXPECT_TRUE(watch_.isPassed(9.0));
}

TEST_F(BoxWatchTest, AMissingBoxIsABreak) {
  watch_.see(messageOf("palm", turnedCube()), 1.0);
  watch_.see(messageOf("thumb", turnedCube()), 1.5);
  EXPECT_FALSE(watch_.isPassed(9.0));
  EXPECT_NE(watch_.failure(9.0).find("Boxes: thumb"), std::string::npos);
  EXPECT_NE(watch_.failure(9.0).find("last box: [-0.683012702, -0.683012702, 1] to "
                                     "[0.683012702, 0.683012702, 2] in frame \"world\""),
            std::string::npos)
      << watch_.failure(9.0);
}

TEST_F(BoxWatchTest, AnIncompleteBoxIsABreak) {
  watch_.see(messageOf("palm", turnedCube()), 1.0);
  const auto incomplete = messageOf("palm", turnedCube());
  incomplete->incomplete = {"palm"};
  watch_.see(incomplete, 1.5);
  EXPECT_FALSE(watch_.isPassed(9.0));
  EXPECT_NE(watch_.failure(9.0).find("incomplete"), std::string::npos);
}

TEST_F(BoxWatchTest, WithoutPublisherNothingHolds) {
  watch_.see(messageOf("palm", turnedCube()), 1.0);
  watch_.losePublisher(1.5);
  EXPECT_FALSE(watch_.isPassed(9.0));
  EXPECT_NE(watch_.failure(9.0).find("nobody publishes"), std::string::npos);
}

TEST_F(BoxWatchTest, TellsHowFarOffTheBoxIs) {
  watch_.see(messageOf("palm", moved(turnedCube(), 0, 0, 1.25)), 1.0);
  EXPECT_NE(watch_.failure(9.0).find("off by 0.25 m"), std::string::npos) << watch_.failure(9.0);
}

TEST_F(BoxWatchTest, TellsThatNothingCame) {
  EXPECT_NE(watch_.failure(9.0).find("no message came"), std::string::npos);
}

TEST(TestReport, EscapesWhatXmlDoesNotAllow) {
  const std::string xml =
      junitXml({"a<b", "\"c\" & d", 0.5, "first\x01 <line>\nsecond \xef\xbf\xbf \xff"});
  EXPECT_NE(xml.find("name=\"a&lt;b\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"&quot;c&quot; &amp; d\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("message=\"first  &lt;line&gt;\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("&#10;second \xef\xbf\xbd \xef\xbf\xbd</failure>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("failures=\"1\""), std::string::npos) << xml;
}

TEST(TestReport, HasNoFailureWhenAllIsWell) {
  const std::string xml = junitXml({"suite", "test", 0.5, ""});
  EXPECT_EQ(xml.find("<failure"), std::string::npos) << xml;
  EXPECT_NE(xml.find("failures=\"0\""), std::string::npos) << xml;
}

}  // namespace
}  // namespace link_bounds
