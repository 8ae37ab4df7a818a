// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random recordings: at each tick the bodies in a zone are those that a new view of the zone's
// frame, without memory, shows in it.
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/Marker.h>

#include <iostream>
#include <set>

#include "link_bounds/ros/messages.h"
#include "testing/marker_testing.h"
#include "testing/random_tf.h"
#include "testing/recorded_testing.h"
#include "testing/sanitized.h"
#include "tools/bag_bounds/scene/recorded_scene.h"
#include "tools/bag_bounds/watch/zone_watch.h"

namespace link_bounds {
namespace {

using Names = std::set<std::string>;

constexpr int kLinks = 8;
constexpr int kObjects = 6;
constexpr int kZones = 12;
constexpr std::int64_t kMillisecond = 1000000;  // ns

class RandomRecording {
 public:
  explicit RandomRecording(std::uint64_t seed)
      : tf_(seed, seed % 3 == 0 ? Oddity::kLoops : Oddity::kNone), numbers_(seed) {
    std::vector<BoundedLink> links;
    for (int i = 0; i < kLinks; ++i)
      links.push_back(meshLink(frameName(i), static_cast<std::uint64_t>(i)));
    scene_.adopt(modelOf(frameName(0), links), time_);
    watch_.watch(scene_.scene(), scene_.tf(), rosNow());
    watch_.onNews(time_, true);
  }

  void receive() {
    time_ += kMillisecond * (1 + pick(40));
    if (pick(40) == 0) time_ += kMillisecond * 1000 * pick(6);
    if (pick(60) == 0) time_ -= kMillisecond * 1000 * (2 + pick(10));
    if (pick(5) == 0) {
      takeMarker();
      return;
    }
    const RandomMessage message = tf_.next();
    tf2_msgs::TFMessage transforms;
    transforms.transforms = message.transforms;
    takeMessage(scene_, message.is_static ? "/tf_static" : "/tf", transforms, time_);
  }

  int ticks() const { return ticks_; }
  std::size_t inside() const { return inside_; }
  std::size_t stays() const {
    std::size_t count = 0;
    for (const ZoneRecord& record : watch_.records())
      count += record.stays.size();
    return count;
  }

 private:
  int pick(int count) { return tf_.pick(count); }
  ros::Time rosNow() const {
    return ros::Time().fromNSec(static_cast<std::uint64_t>(scene_.now()));
  }

  std::vector<Zone> randomZones() {
    std::vector<Zone> zones;
    for (int i = 0; i < kZones; ++i) {
      const Eigen::Vector3d corner = numbers_.vector(2);
      Aabb box;
      box.extend(corner);
      box.extend(corner + (numbers_.vector(1).array() + 1).matrix());
      zones.push_back({std::to_string(i), i % 3 == 0 ? "" : frameName(pick(kLinks)), box});
    }
    return zones;
  }

  void takeMarker() {
    visualization_msgs::Marker marker = markerOf(visualization_msgs::Marker::CUBE, {0.2, 0.3, 0.4});
    marker.header.frame_id = frameName(pick(kLinks));
    marker.ns = "object";
    marker.id = pick(kObjects);
    marker.action = pick(4) == 0 ? visualization_msgs::Marker::DELETE : 0;
    marker.frame_locked = pick(2) == 0;
    marker.pose.position = toPoint(numbers_.vector(1));
    takeMessage(scene_, "/objects", marker, time_);
  }

  void onStep(std::int64_t now, bool is_tick) {
    watch_.onStep(now, is_tick, true);
    if (is_tick) compare();
  }

  /// What is stale is found at ticks.
  void compare() {
    ++ticks_;
    for (const ZoneRecord& record : watch_.records()) {
      Names found;
      for (const Stay& stay : record.stays) {
        if (stay.left.recorded == 0) found.insert(stay.name);
      }
      inside_ += found.size();
      ASSERT_LT(record.stays.size(), ZoneWatch::kMaxStays);
      EXPECT_EQ(found, namesIn(record.zone)) << "zone " << record.zone.name << ", tick " << ticks_;
    }
  }

  Names namesIn(const Zone& zone) {
    Names names;
    FrameView view(zone.frame, scene_.scene(), scene_.tf(), rosNow());
    view.update(rosNow());
    scene_.scene().forEach([&](const SceneBody& body) {
      const std::optional<Aabb> box = view.placed(body).state.box;
      if (box && signedDistance(*box, zone.box) <= 0) names.insert(body.name);
    });
    return names;
  }

  RandomTf tf_;
  brute_force::Random numbers_;
  std::int64_t time_ = std::int64_t{1700000000} * 1000000000;
  RecordedScene scene_{[](const std::string&) { return LoadedMesh(); },
                       [this](std::int64_t now) { watch_.onNews(now, true); },
                       [this](std::int64_t now, bool is_tick) { onStep(now, is_tick); }};
  ZoneWatch watch_{randomZones()};
  int ticks_ = 0;
  std::size_t inside_ = 0;
};

TEST(ZoneSequences, BodiesInAZoneAreThoseOfANewView) {
  constexpr int kRecordings = repetitions(40);
  int ticks = 0;
  std::size_t inside = 0, stays = 0;
  for (std::uint64_t seed = 1; seed <= kRecordings && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomRecording recording(seed);
    for (int i = 0; i < 300; ++i)
      recording.receive();
    ticks += recording.ticks();
    inside += recording.inside();
    stays += recording.stays();
  }
  std::cout << ticks << " ticks, " << stays << " stays, " << inside << " bodies in zones\n";
  EXPECT_GT(ticks, 30 * kRecordings);
  EXPECT_GT(stays, 10U * kRecordings);
}

}  // namespace
}  // namespace link_bounds
