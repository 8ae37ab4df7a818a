// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes of other nodes become objects, come and go with the messages, and grow old.
#include <link_bounds/AxisAlignedBoxArray.h>

#include <limits>
#include <random>

#include "node/objects/object_source.h"
#include "testing/live_objects_testing.h"
#include "testing/marker_testing.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Of 2 x 4 x 6 m.
AxisAlignedBox boxAround(const std::string& name, const Eigen::Vector3d& center, double stamp) {
  AxisAlignedBox box;
  box.name = name;
  box.stamp = ros::Time(stamp);
  box.min = pointMessage(center - Eigen::Vector3d(1, 2, 3));
  box.max = pointMessage(center + Eigen::Vector3d(1, 2, 3));
  return box;
}

AxisAlignedBoxArray arrayOf(const std::string& frame, const std::vector<AxisAlignedBox>& boxes,
                            const std::vector<std::string>& incomplete = {}) {
  AxisAlignedBoxArray array;
  array.header.frame_id = frame;
  array.boxes = boxes;
  array.incomplete = incomplete;
  return array;
}

class NeighboursTest : public LiveObjectsTest {
 protected:
  bool take(const AxisAlignedBoxArray& array, const std::string& sender = "/right/bounds") {
    return source_.takeNeighbour(array, sender, now_);
  }

  bool takeMarker(int action) {
    visualization_msgs::Marker marker =
        markerOf(visualization_msgs::Marker::CUBE, Eigen::Vector3d::Ones());
    marker.header.frame_id = "map";
    marker.ns = kKey.ns;
    marker.id = kKey.id;
    marker.action = action;
    return source_.take(std::move(marker), "/camera", now_);
  }

  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& [key, object] : objects_.objects())
      result.insert(object.content->bounded.name);
    return result;
  }

  const LiveObject* find(const std::string& name) const {
    const auto found = objects_.objects().find(*parseObjectName(name));
    return found == objects_.objects().end() ? nullptr : &found->second;
  }

  const LiveObject& arm() const { return *find("/right/bounds/arm"); }

  ObjectSource source_{objects_, [](const std::string&) {}};
};

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
  expect(arrayOf("", {boxAround("arm", {0, 0, 0}, 99)}), "header.frame_id is empty");
  expect(arrayOf("nowhere", {boxAround("arm", {0, 0, 0}, 99)}), "no transform");
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

/// What a sender last said, and when.
struct Sent {
  std::map<std::string, AxisAlignedBox> boxes;
  std::set<std::string> incomplete;
  ros::Time at;

  bool isSilent(ros::Time now) const { return (now - at).toSec() > 2; }
  bool isBad(const std::string& link) const { return std::isnan(boxes.at(link).min.x); }
  bool isStatic(const std::string& link) const { return boxes.at(link).stamp.isZero(); }
};

class NeighbourSequencesTest : public NeighboursTest {
 protected:
  bool chance(int percent) { return static_cast<int>(random_() % 100) < percent; }

  void send(const std::string& sender) {
    Sent& last = sent_[sender] = {{}, {}, now_};
    AxisAlignedBoxArray array = arrayOf("map", {boxAround("/other/node/arm", {0, 0, 0}, 1)});
    for (const std::string link : {"base", "arm", "held/1", "right/tool"}) {
      const double x = chance(20) ? kNan : static_cast<double>(random_() % 3);
      const double stamp = link == "base" ? 0 : now_.toSec() - 0.01;
      if (chance(70)) array.boxes.push_back(last.boxes[link] = boxAround(link, {x, 0, 0}, stamp));
      if (chance(10)) array.incomplete.push_back(*last.incomplete.insert(link).first);
    }
    take(array, sender);
  }

  void reload() {
    for (auto& [sender, last] : sent_) {
      for (const auto& [link, box] : std::map<std::string, AxisAlignedBox>(last.boxes)) {
        if (!last.isSilent(now_) || last.isStatic(link) || last.isBad(link)) continue;
        last.boxes.erase(link);
        last.incomplete.erase(link);
      }
    }
    adopt("map", 2);
  }

  void expectNames() const {
    std::set<std::string> expected;
    if (has_marker_) expected.insert("scene/1");
    for (const auto& [sender, last] : sent_) {
      for (const auto& [link, box] : last.boxes)
        expected.insert(neighbourName(sender, link));
      for (const std::string& link : last.incomplete)
        expected.insert(neighbourName(sender, link));
    }
    ASSERT_EQ(names(), expected);
  }

  void expectBoxes(const std::string& sender, const Sent& last) const {
    for (const auto& [link, box] : last.boxes) {
      const BoxState& state = find(neighbourName(sender, link))->state;
      const bool has_none = last.isBad(link) || (last.isSilent(now_) && !last.isStatic(link));
      ASSERT_EQ(state.box.has_value(), !has_none) << sender << link;
      EXPECT_EQ(state.incomplete, has_none || last.incomplete.count(link) > 0);
      if (state.box) {
        EXPECT_NEAR(state.box->min().x(), box.min.x, kTolerance);
      }
    }
  }

  std::mt19937 random_{1};
  std::map<std::string, Sent> sent_{{"/right/bounds", {}}, {"/left", {}}};
  bool has_marker_ = false;
};

TEST_F(NeighbourSequencesTest, ObjectsAreWhatTheNewestMessagesSay) {
  for (int step = 0; step < repetitions(3000); ++step) {
    SCOPED_TRACE(step);
    for (const char* sender : {"/right/bounds", "/left"}) {
      if (chance(40)) send(sender);
    }
    if (chance(20)) {
      has_marker_ = chance(50);
      takeMarker(has_marker_ ? visualization_msgs::Marker::ADD
                             : visualization_msgs::Marker::DELETEALL);
    }
    pass(chance(5) ? 3 : 0.1);
    if (chance(5)) reload();
    ASSERT_NO_FATAL_FAILURE(expectNames());
    for (const auto& [sender, last] : sent_)
      ASSERT_NO_FATAL_FAILURE(expectBoxes(sender, last));
  }
}

}  // namespace
}  // namespace link_bounds
