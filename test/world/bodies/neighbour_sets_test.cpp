// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One sender may carry several robots; no two objects have one name; who has ended leaves nothing.
#include <chrono>
#include <functional>

#include "testing/neighbours_testing.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using Names = std::set<std::string>;

const char kRelay[] = "/relay";

class NeighbourSetsTest : public NeighboursTest {
 protected:
  static AxisAlignedBoxArray boxesOf(const std::vector<std::string>& names,
                                     const std::string& frame = "map", double x = 0) {
    AxisAlignedBoxArray array = arrayOf(frame, {});
    for (const std::string& name : names)
      array.boxes.push_back(boxAround(name, {x, 0, 0}, 99));
    return array;
  }

  Names incomplete() const {
    Names result;
    for (const auto& [key, object] : objects_.objects())
      if (object.state.incomplete) result.insert(object.content->bounded.name);
    return result;
  }

  bool takeFrom(const boost::shared_ptr<int>& connection, const AxisAlignedBoxArray& array) {
    return neighbours_.take(array, {"/right/bounds", connection}, now_);
  }

  /// After so much wall time [s].
  bool removeEnded(double seconds) {
    const auto has_left = [this](const std::string&) { return has_left_; };
    return neighbours_.removeEnded(ros::SteadyTime(1000 + seconds), has_left);
  }

  bool has_left_ = true;  ///< in order, who has lost its connection
};

TEST_F(NeighbourSetsTest, ARelayMayCarryTwoRobots) {
  for (int i = 0; i < 3; ++i) {
    take(boxesOf({"a_arm", "a_hand"}), kRelay);
    take(boxesOf({"b_arm", "b_hand"}), kRelay);
    EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/a_hand", "/relay/b_arm", "/relay/b_hand"}));
  }
  take(boxesOf({"a_arm"}), kRelay);
  EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/b_arm", "/relay/b_hand"}));
  take(arrayOf("map", {}, {"b_hand"}), kRelay);
  EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/b_hand"}));
  EXPECT_EQ(incomplete(), Names{"/relay/b_hand"});
}

TEST_F(NeighbourSetsTest, RobotsThatKnowTheSameObjectsAreTwo) {
  take(boxesOf({"a_arm", "scene/1"}), kRelay);
  take(boxesOf({"b_arm", "scene/1"}), kRelay);
  EXPECT_EQ(names(),
            (Names{"/relay/a_arm", "/relay/b_arm", "/relay/scene/1", "/relay/map/scene/1"}));
  take(boxesOf({"a_arm"}), kRelay);
  EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/b_arm", "/relay/map/scene/1"}));
}

TEST_F(NeighbourSetsTest, RobotsOfTheSameLinksDifferInTheirFrames) {
  hear("map", "a/base", 99, 0, 0);
  hear("map", "b/base", 99, 0, 50);
  for (int i = 0; i < 3; ++i) {
    take(boxesOf({"arm", "hand"}, "a/base"), kRelay);
    take(boxesOf({"arm", "hand"}, "b/base"), kRelay);
    EXPECT_EQ(names(),
              (Names{"/relay/arm", "/relay/hand", "/relay/b/base/arm", "/relay/b/base/hand"}));
    EXPECT_EQ(incomplete(), Names());
    EXPECT_NEAR(find("/relay/arm")->state.box->max().x(), 1, kTolerance);
    EXPECT_NEAR(find("/relay/b/base/arm")->state.box->max().x(), 51, kTolerance);
  }
  take(boxesOf({"arm"}, "b/base"), kRelay);
  EXPECT_EQ(names(), (Names{"/relay/arm", "/relay/hand", "/relay/b/base/arm"}));
}

TEST_F(NeighbourSetsTest, MessagesWithoutLinksAreOneSet) {
  take(boxesOf({"a_arm"}), kRelay);
  take(boxesOf({"scene/1"}), kRelay);
  take(boxesOf({"scene/2"}), kRelay);
  EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/scene/2"}));
  EXPECT_FALSE(take(boxesOf({}), kRelay)) << "it does not tell whose it is";
  EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/scene/2"}));
  take(boxesOf({"scene/1"}), "/camera");
  EXPECT_TRUE(take(boxesOf({}), "/camera")) << "the only set there is";
  EXPECT_EQ(names(), (Names{"/relay/a_arm", "/relay/scene/2"}));
}

TEST_F(NeighbourSetsTest, AMessageMayShowThatTwoSetsAreOne) {
  take(boxesOf({"arm"}));
  take(boxesOf({"hand"}));
  take(boxesOf({"arm", "hand"}));
  EXPECT_EQ(incomplete(), Names());
  take(boxesOf({"hand"}));
  EXPECT_EQ(names(), Names{"/right/bounds/hand"});
}

TEST_F(NeighbourSetsTest, AMessageWithoutFrameEndsNoRobot) {
  hear("map", "a/base", 99, 0, 0);
  hear("map", "b/base", 99, 0, 50);
  const Names all{"/relay/arm", "/relay/hand", "/relay/b/base/arm", "/relay/b/base/hand"};
  for (int i = 0; i < 2; ++i) {
    take(boxesOf({"arm", "hand"}, "a/base"), kRelay);
    take(boxesOf({"arm", "hand"}, "b/base"), kRelay);
    take(boxesOf({"arm", "hand"}, ""), kRelay);
    EXPECT_EQ(names(), all);
    take(boxesOf({"arm", "hand"}, "b/base"), kRelay);
    EXPECT_EQ(names(), all) << "it is no set of another frame now";
  }
  take(boxesOf({"arm", "hand"}, "a/base"), kRelay);
  EXPECT_EQ(incomplete(), Names());
}

TEST_F(NeighbourSetsTest, ATickLooksAtNoNamesIfNoneIsForgotten) {
  std::vector<std::string> names;
  for (int i = 0; i < 20000; ++i)
    names.push_back("link_" + std::to_string(i));
  const AxisAlignedBoxArray array = boxesOf(names);
  const auto seconds = [](const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double message = seconds([&] { take(array); });
  const double ticks = seconds([&] {
    for (int i = 0; i < 1000; ++i)
      removeEnded(i);
  });
  EXPECT_LT(ticks, message);
}

TEST_F(NeighbourSetsTest, MarkersAndNeighboursDoNotTouchEachOther) {
  const ObjectKey key{"/right/cup", 7};
  take(boxesOf({"cup/7"}, "map", 5), "/right");
  takeMarker(Marker::DELETE, key);
  EXPECT_NEAR(find("/right/cup/7")->state.box->max().x(), 6, kTolerance);
  takeMarker(Marker::ADD, key);
  EXPECT_EQ(names(), Names{"/right/cup/7"});
  EXPECT_EQ(incomplete(), Names{"/right/cup/7"}) << "the marker has no box";
  const auto [begin, end] = objects_.named(key);
  ASSERT_EQ(std::distance(begin, end), 2);
  EXPECT_EQ(objects_.reason(begin->second),
            "its name is that of a box of /right; give one of them another name");
  EXPECT_NEAR(std::next(begin)->second.state.box->max().x(), 6, kTolerance);
  EXPECT_FALSE(take(boxesOf({"cup/7"}, "map", 5), "/right"));
  takeMarker(Marker::DELETE, key);
  EXPECT_EQ(incomplete(), Names());
  takeMarker(Marker::ADD, key);
  takeMarker(Marker::DELETEALL);
  EXPECT_EQ(incomplete(), Names());
  EXPECT_NEAR(find("/right/cup/7")->state.box->max().x(), 6, kTolerance);
}

TEST_F(NeighbourSetsTest, AMarkerGetsItsNameWhenItIsFree) {
  const ObjectKey key{"/right", 5};
  takeMarker(Marker::ADD, key);
  take(boxesOf({"5", "arm"}), "/right");
  EXPECT_EQ(names(), (Names{"/right/5", "/right/map/5", "/right/arm"}));
  EXPECT_EQ(incomplete(), Names());
  takeMarker(Marker::DELETE, key);
  take(boxesOf({"5", "arm"}), "/right");
  EXPECT_EQ(names(), (Names{"/right/5", "/right/arm"}));
  takeMarker(Marker::ADD, key);
  EXPECT_EQ(incomplete(), Names{"/right/5"});
  take(boxesOf({"arm"}), "/right");
  takeMarker(Marker::ADD, key);
  EXPECT_EQ(incomplete(), Names());
}

TEST_F(NeighbourSetsTest, ARefusedMarkerGetsItsBoxWhenTheNeighbourHasEnded) {
  auto connection = boost::make_shared<int>();
  takeFrom(connection, boxesOf({"7", "arm"}, "map", 5));
  removeEnded(0);
  EXPECT_TRUE(takeMarker(Marker::ADD, {"/right/bounds", 7}));
  EXPECT_EQ(incomplete(), Names{"/right/bounds/7"});
  EXPECT_FALSE(pass(0.05));
  connection.reset();
  removeEnded(1);
  removeEnded(2);
  EXPECT_EQ(incomplete(), Names{"/right/bounds/7"});
  EXPECT_TRUE(pass(0.05));
  EXPECT_EQ(incomplete(), Names());
  ASSERT_TRUE(find("/right/bounds/7")->state.box);
  EXPECT_NEAR(find("/right/bounds/7")->state.box->max().x(), 0.5, kTolerance);
  EXPECT_EQ(objects_.reason(*find("/right/bounds/7")), "");
}

TEST_F(NeighbourSetsTest, ARefusedMarkerIsPlacedAtItsStampAllTheSame) {
  takeMarker(Marker::ADD, {"/right/bounds", 7});
  take(boxesOf({"7"}, "map", 5));
  visualization_msgs::Marker marker = markerOf(Marker::CUBE, Eigen::Vector3d::Ones());
  marker.ns = "/right/bounds/map";
  marker.id = 7;
  marker.header.frame_id = "moving";
  marker.header.stamp = now_;
  hear("map", "moving", now_.toSec(), 0, 8);
  source_.take(std::move(marker), "/camera", now_);
  EXPECT_EQ(incomplete(), Names{"/right/bounds/map/7"});
  hear("map", "moving", now_.toSec() + 20, 0, 30);
  takeMarker(Marker::DELETE, {"/right/bounds", 7});
  take(boxesOf({"7"}, "map", 5));
  EXPECT_TRUE(pass(0.05));
  EXPECT_EQ(incomplete(), Names());
  EXPECT_NEAR(find("/right/bounds/map/7")->state.box->max().x(), 8.5, kTolerance);
}

TEST_F(NeighbourSetsTest, TwoSendersNeverShareAName) {
  take(boxesOf({"b/c", "x"}, "map", 1), "/a");
  take(boxesOf({"c", "y"}, "map", 2), "/a/b");
  EXPECT_EQ(names(), (Names{"/a/b/c", "/a/x", "/a/b/map/c", "/a/b/y"}));
  EXPECT_NEAR(find("/a/b/c")->state.box->max().x(), 2, kTolerance);
  EXPECT_NEAR(find("/a/b/map/c")->state.box->max().x(), 3, kTolerance);
  take(boxesOf({"x"}), "/a");
  EXPECT_EQ(names(), (Names{"/a/x", "/a/b/map/c", "/a/b/y"}));
  take(boxesOf({"y"}), "/a/b");
  EXPECT_EQ(names(), (Names{"/a/x", "/a/b/y"}));
}

TEST_F(NeighbourSetsTest, ABoxWithoutAFreeNameIsRefused) {
  takeMarker(Marker::ADD, {"/relay", 1});
  takeMarker(Marker::ADD, {"/relay/map", 1});
  take(boxesOf({"1", "arm"}), kRelay);
  EXPECT_EQ(names(), (Names{"/relay/1", "/relay/map/1", "/relay/arm"}));
  EXPECT_EQ(incomplete(), Names{"/relay/1"});
  EXPECT_TRUE(find("/relay/1")->state.box) << "that of the marker";
}

TEST_F(NeighbourSetsTest, ASenderThatEndsLeavesNothing) {
  auto connection = boost::make_shared<int>();
  takeFrom(connection, arrayOf("map", {boxAround("arm", {0, 0, 0}, 99)}, {"hand"}));
  take(boxesOf({"arm"}), "/left");
  removeEnded(0);
  pass(3);
  EXPECT_EQ(incomplete(), (Names{"/right/bounds/arm", "/right/bounds/hand", "/left/arm"}));
  connection.reset();
  EXPECT_FALSE(removeEnded(100));
  EXPECT_FALSE(removeEnded(100.4));
  EXPECT_TRUE(removeEnded(100.6));
  EXPECT_EQ(names(), Names{"/left/arm"});
}

TEST_F(NeighbourSetsTest, ASenderThatHasNotLeftIsSilent) {
  auto connection = boost::make_shared<int>();
  takeFrom(connection, boxesOf({"arm"}));
  connection.reset();
  has_left_ = false;
  EXPECT_FALSE(removeEnded(0));
  EXPECT_FALSE(removeEnded(100));
  EXPECT_EQ(names(), Names{"/right/bounds/arm"});
  pass(3);
  EXPECT_FALSE(removeEnded(103));
  EXPECT_EQ(incomplete(), Names{"/right/bounds/arm"});
  takeFrom(boost::make_shared<int>(), boxesOf({}));  // started again, without a robot yet
  EXPECT_EQ(incomplete(), Names{"/right/bounds/arm"});
  has_left_ = true;
  EXPECT_TRUE(removeEnded(104));
  EXPECT_EQ(names(), Names{});
}

TEST_F(NeighbourSetsTest, ASenderThatConnectsAgainKeepsItsBoxes) {
  auto connection = boost::make_shared<int>();
  takeFrom(connection, boxesOf({"arm"}));
  connection = boost::make_shared<int>();
  removeEnded(0);
  removeEnded(0.4);
  takeFrom(connection, boxesOf({"arm"}));
  EXPECT_FALSE(removeEnded(0.6));
  EXPECT_FALSE(removeEnded(100));
  EXPECT_EQ(names(), Names{"/right/bounds/arm"});
}

// A node that was started again with another robot says nothing of the former one.
TEST_F(NeighbourSetsTest, StaticBoxesOfBeforeARestartFallSilent) {
  auto connection = boost::make_shared<int>();
  const auto still = [](const std::string& name) {
    return arrayOf("map", {boxAround(name, {0, 0, 0}, 0)}, {name + "_tip"});
  };
  takeFrom(connection, still("old"));
  takeFrom(connection, still("same"));
  connection = boost::make_shared<int>();
  takeFrom(connection, boxesOf({}));
  pass(3);
  EXPECT_EQ(incomplete(), (Names{"/right/bounds/old_tip", "/right/bounds/same_tip"}));
  takeFrom(connection, still("new"));
  takeFrom(connection, still("same"));
  pass(1.9);
  EXPECT_TRUE(find("/right/bounds/old")->state.box);
  EXPECT_TRUE(pass(0.2));
  EXPECT_FALSE(find("/right/bounds/old")->state.box);
  EXPECT_TRUE(find("/right/bounds/same")->state.box) << "it was sent again";
  EXPECT_EQ(incomplete(), (Names{"/right/bounds/old", "/right/bounds/old_tip",
                                 "/right/bounds/same_tip", "/right/bounds/new_tip"}));
  const Names all = names();
  pass(1000);
  EXPECT_EQ(names(), all) << "nobody has said that it is gone";
}

TEST_F(NeighbourSetsTest, ANodeThatServedObjectsAloneMayGetARobot) {
  take(boxesOf({"scene/1", "scene/2"}));
  take(boxesOf({"arm", "scene/1", "scene/2", "scene/3"}));
  take(boxesOf({"arm", "scene/2", "scene/3"}));
  EXPECT_EQ(names(),
            (Names{"/right/bounds/arm", "/right/bounds/scene/2", "/right/bounds/scene/3"}));
  take(boxesOf({"scene/3"}));  // of a further node behind the same relay
  take(boxesOf({"arm", "scene/3"}));
  EXPECT_EQ(names(),
            (Names{"/right/bounds/arm", "/right/bounds/scene/3", "/right/bounds/map/scene/3"}))
      << "the robot is known";
}

// A relay may carry a cell that sends once, and a robot that knows some of the same objects.
TEST_F(NeighbourSetsTest, ARobotThatKnowsSomeOfTheObjectsOfACellEndsNone) {
  AxisAlignedBoxArray cell =
      arrayOf("map", {boxAround("scene/1", {0, 0, 0}, 0), boxAround("wall/1", {0, 0, 0}, 0)});
  take(cell, kRelay);
  take(boxesOf({"arm", "scene/1"}), kRelay);
  EXPECT_EQ(names(),
            (Names{"/relay/arm", "/relay/scene/1", "/relay/wall/1", "/relay/map/scene/1"}));
  cell.boxes.pop_back();
  take(cell, "/other");
  take(boxesOf({"arm", "scene/1"}, "map", 5), "/other");
  EXPECT_EQ(names().count("/other/map/scene/1"), 1U) << "it is in another place";
}

// It serves objects alone first, as before.
TEST_F(NeighbourSetsTest, ANodeThatIsStartedAgainMayGetItsRobotLater) {
  auto connection = boost::make_shared<int>();
  takeFrom(connection, boxesOf({"arm", "scene/1"}));
  connection = boost::make_shared<int>();
  takeFrom(connection, boxesOf({"scene/1"}));
  takeFrom(connection, boxesOf({"arm", "scene/1"}, "map", 5));
  EXPECT_EQ(names(), (Names{"/right/bounds/arm", "/right/bounds/scene/1"}));
  EXPECT_NEAR(find("/right/bounds/scene/1")->state.box->max().x(), 6, kTolerance);
}

TEST_F(NeighbourSetsTest, ASilentSenderIsForgottenAfterTenTimesTheTimeout) {
  take(
      arrayOf("map", {boxAround("arm", {0, 0, 0}, 99), boxAround("base", {0, 0, 0}, 0)}, {"hand"}));
  pass(2.1);
  EXPECT_EQ(incomplete(), (Names{"/right/bounds/arm", "/right/bounds/hand"}));
  EXPECT_FALSE(pass(17.8));
  EXPECT_TRUE(pass(0.3));
  EXPECT_EQ(names(), Names{"/right/bounds/base"}) << "it is static";
  take(boxesOf({"arm"}));
  EXPECT_TRUE(pass(1000)) << "the clock jumped ahead: incomplete first";
  EXPECT_EQ(incomplete(), Names{"/right/bounds/arm"});
  EXPECT_FALSE(pass(17));
  EXPECT_TRUE(pass(2));
}

// It sends once, because nothing of it changes.
TEST_F(NeighbourSetsTest, ANameWithoutABoxIsAsStaticAsTheBoxesBesideIt) {
  AxisAlignedBox bad = boxAround("bad", {0, 0, 0}, 0);
  bad.max.x = kNan;
  for (const char* ns : {"/right/bounds/cup", "/right/bounds/map/cup"})
    takeMarker(visualization_msgs::Marker::ADD, {ns, 7});
  take(arrayOf("map", {boxAround("base", {0, 0, 0}, 0), boxAround("cup/7", {0, 0, 0}, 0), bad},
               {"hand"}));
  const Names all = incomplete();
  EXPECT_EQ(all.size(), 3u);
  EXPECT_FALSE(pass(1000));
  EXPECT_EQ(incomplete(), all);
  take(arrayOf("map", {}, {"hand"}));
  pass(1000);
  pass(1000);
  EXPECT_EQ(incomplete(), Names{}) << "nothing tells that it is static";
}

/// Loops of a bag that are shorter than the time to wait.
class LoopTest : public NeighbourSetsTest {
 protected:
  /// Returns the seconds until `is_reached`, at most 100.
  double playUntil(double length, const std::function<bool()>& is_reached) {
    double played = 0;
    while (played < 100 && !is_reached()) {
      if (now_.toSec() >= 100 + length) {
        now_ = ros::Time(100);
        restart();
      }
      pass(0.1);
      played += 0.1;
    }
    return played;
  }
};

TEST_F(LoopTest, DoesNotMakeSilenceShorter) {
  for (const double length : {1.5, 7.0}) {
    take(boxesOf({"arm"}));
    const auto is_silent = [&] { return !find("/right/bounds/arm")->state.box; };
    EXPECT_NEAR(playUntil(length, is_silent), 2, 0.3) << length;
    EXPECT_NEAR(playUntil(length, [&] { return names().empty(); }), 18, 0.5) << length;
  }
}

}  // namespace
}  // namespace link_bounds
