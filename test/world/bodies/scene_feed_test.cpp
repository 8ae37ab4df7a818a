// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that are taken together lead to the same scene as one update for each of them.
#include "world/bodies/scene_feed.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "testing/live_boxes_testing.h"
#include "testing/random_tf.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

/// A feed with some links of a random tf.
struct Fed {
  Fed(RandomTf& tf, bool joins_messages) : joins(joins_messages) {
    std::vector<BoundedLink> links;
    for (int i = 1; i < tf.frames(); i += 3)
      links.push_back(meshLink(frameName(i), static_cast<std::uint64_t>(i)));
    feed.adopt(modelOf(frameName(0), links), ros::Time(100));
    feed.setJoining(joins);
  }

  void update(ros::Time now) {
    feed.update(now);
    joined += feed.takeJoined();
  }

  bool joins;
  int news = 0;
  std::size_t joined = 0;
  SceneFeed feed{{[](const MeshRequest&) {}, [this] { ++news; }}};
};

/// Follows a frame, is replaced or removed. One with a stamp may have to wait for its transform and
/// is then placed by what tf knows at the next update, so that it may differ.
visualization_msgs::Marker randomMarker(RandomTf& tf) {
  visualization_msgs::Marker marker;
  marker.ns = "scene";
  marker.id = tf.pick(8);
  marker.action = tf.pick(5) == 0 ? visualization_msgs::Marker::DELETE : 0;
  marker.type = visualization_msgs::Marker::CUBE;
  marker.header.frame_id = frameName(tf.pick(tf.frames()));
  marker.pose.orientation.w = 1;
  marker.pose.position.x = tf.pick(5);
  marker.scale.x = marker.scale.y = marker.scale.z = 1 + tf.pick(3);
  return marker;
}

std::vector<std::string> texts(const SceneFeed& feed) {
  std::vector<std::string> lines;
  const_cast<SceneFeed&>(feed).scene().forEach([&](const SceneBody& body) {
    const BoxState& state = body.state;
    std::ostringstream line;
    line.precision(17);
    line << body.name << ' ' << state.stamp << ' ' << state.incomplete;
    if (state.box)
      line << ' ' << state.box->min().transpose() << ' ' << state.box->max().transpose();
    lines.push_back(line.str());
  });
  return lines;
}

class JoinedMessages : public testing::TestWithParam<std::uint64_t> {};

TEST_P(JoinedMessages, GiveTheSameSceneAsOneUpdateEach) {
  RandomTf tf(GetParam(), GetParam() % 3 == 0 ? Oddity::kLoops : Oddity::kNone);
  Fed single(tf, false), several(tf, true);
  std::size_t messages = 0, updates = 0, since_update = 0;
  ros::Time now(1000);
  for (int i = 0; i < 400; ++i) {
    now += ros::Duration(0.001);
    if (tf.pick(40) == 0) {
      several.update(now);
      updates += since_update > 0 ? 1 : 0;
      since_update = 0;
      now += ros::Duration(tf.pick(10) == 0 ? -2.0 : 1.5);
      for (Fed* fed : {&single, &several})
        fed->feed.onTick(now);
    }
    if (tf.pick(4) == 0) {
      const visualization_msgs::Marker marker = randomMarker(tf);
      for (Fed* fed : {&single, &several}) {
        visualization_msgs::Marker copy = marker;
        fed->feed.onMarkers(&copy, 1, "/sender", now);
      }
    } else {
      const RandomMessage message = tf.next();
      const std::vector<TransformView> views(message.transforms.begin(), message.transforms.end());
      for (Fed* fed : {&single, &several})
        fed->feed.onTransforms(
            views, message.is_static, [] { return "/sender"; }, now, ros::SteadyTime::now());
    }
    ++messages;
    ++since_update;
    if (tf.pick(6) > 0) continue;
    if (tf.pick(2) == 0) {
      for (Fed* fed : {&single, &several})
        fed->feed.onTick(now);
    }
    several.update(now);
    updates += since_update > 0 ? 1 : 0;
    since_update = 0;
    ASSERT_EQ(texts(single.feed), texts(several.feed)) << "step " << i;
  }
  several.update(now);
  updates += since_update > 0 ? 1 : 0;
  EXPECT_EQ(several.joined, messages - updates);
  single.update(now);
  EXPECT_EQ(single.joined, 0u);
  EXPECT_LT(several.news, single.news);
}

/// Two links of the fixed frame, and the time.
class SceneFeedTest : public testing::Test {
 protected:
  SceneFeedTest() {
    auto model = std::make_shared<Model>(*modelOf("base", {meshLink("a", 1), meshLink("b", 2)}));
    model->parameters.timeout = 1;
    feed_.adopt(model, ros::Time(100));
  }

  void send(const std::string& link, double stamp, double now) { send(link, stamp, now, steady_); }
  void send(const std::string& link, double stamp, double now, ros::SteadyTime arrival) {
    const std::vector<geometry_msgs::TransformStamped> transforms{
        edge("base", link, stamp, Eigen::Quaterniond::Identity(), {stamp, 0, 0})};
    feed_.onTransforms(
        {transforms.begin(), transforms.end()}, false, [] { return "/sender"; }, ros::Time(now),
        arrival);
  }

  /// Names of the links with a box, and its stamp.
  std::map<std::string, double> boxes() {
    std::map<std::string, double> result;
    feed_.scene().forEach([&](const SceneBody& body) {
      if (body.state.box)
        result[body.name] = static_cast<double>(body.state.stamp / 1000000) / 1000;
    });
    return result;
  }

  using Boxes = std::map<std::string, double>;

  ros::SteadyTime steady_{1000};
  SceneFeed feed_{{[](const MeshRequest&) {}, [] {}}, [this] { return steady_; }};
};

/// A busy node takes them long after the jump that it has seen.
TEST_F(SceneFeedTest, WhatWaitedSinceBeforeAJumpBackIsDropped) {
  send("a", 107, 107);
  EXPECT_EQ(boxes(), (Boxes{{"a", 107}}));
  const ros::SteadyTime before = steady_;
  steady_ += ros::WallDuration(3);
  feed_.onTick(ros::Time(100));
  steady_ += ros::WallDuration(2);
  send("a", 107.25, 101, before);
  EXPECT_EQ(boxes(), Boxes());
  send("a", 100.5, 101, before + ros::WallDuration(3));
  EXPECT_EQ(boxes(), (Boxes{{"a", 100.5}}));
  send("a", 101, 101);
  EXPECT_EQ(boxes(), (Boxes{{"a", 101}}));
}

/// The sender has the new clock, and the node has not.
TEST_F(SceneFeedTest, WhatComesFromAfterAJumpAheadIsNotStale) {
  send("a", 100, 100);
  send("b", 100, 100);
  send("a", 200, 100);
  feed_.onTick(ros::Time(200.1));
  EXPECT_EQ(boxes(), (Boxes{{"a", 200}}));
  feed_.onTick(ros::Time(201));
  EXPECT_EQ(boxes(), (Boxes{{"a", 200}}));
  feed_.onTick(ros::Time(201.2));
  EXPECT_EQ(boxes(), Boxes());
}

/// Its stamp is not that of the new clock.
TEST_F(SceneFeedTest, AStampFarAheadIsStaleAfterAJumpAheadToAnotherTime) {
  send("a", 200, 100);
  send("b", 101.9, 100);
  feed_.onTick(ros::Time(102.5));
  EXPECT_EQ(boxes(), Boxes());
}

/// A clock that is slow to go on has not jumped.
TEST_F(SceneFeedTest, AStampAheadIsStaleAfterAStepOfTheClock) {
  send("a", 101.5, 100);
  feed_.onTick(ros::Time(101.5));
  EXPECT_EQ(boxes(), Boxes());
}

INSTANTIATE_TEST_SUITE_P(Seeds, JoinedMessages,
                         testing::Range<std::uint64_t>(1, 1 + repetitions(100)));

}  // namespace
}  // namespace link_bounds
