// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// An interrupt ends a message of markers in its middle. Frames without news are forgotten.
#include "tools/bag_bounds/scene/recorded_scene.h"

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <csignal>

#include "testing/live_boxes_testing.h"
#include "testing/marker_testing.h"
#include "testing/recorded_testing.h"
#include "tools/command_line/interrupt.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

class RecordedSceneTest : public testing::Test {
 protected:
  RecordedSceneTest() { scene_.adopt(modelOf("frame", {}), kTime); }

  /// As many markers of a type, with a mesh each where they are meshes.
  bool take(int type, int count) {
    visualization_msgs::MarkerArray array;
    for (int i = 0; i < count; ++i) {
      array.markers.push_back(markerOf(type, {1, 1, 1}));
      array.markers.back().id = i;
      if (type == Marker::MESH_RESOURCE)
        array.markers.back().mesh_resource = "file:///" + std::to_string(i) + ".stl";
    }
    return takeMessage(scene_, "/objects", array, kTime);
  }

  static constexpr std::int64_t kTime = 1'000'000'000;  // ns

  int news_ = 0, loads_ = 0, steps_ = 0;
  RecordedScene scene_{[this](const std::string&) {
                         ++loads_;
                         std::raise(SIGINT);
                         return LoadedMesh{nullptr, "interrupted"};
                       },
                       [this](std::int64_t) { ++news_; }, [this](std::int64_t, bool) { ++steps_; }};
};

/// As for detections with ever new names: memory does not grow with the length of a bag.
TEST_F(RecordedSceneTest, FramesWithoutNewsAreForgotten) {
  constexpr int kPerSecond = 100, kSeconds = 1000;
  for (int second = 0; second < kSeconds; ++second) {
    tf2_msgs::TFMessage message;
    for (int i = 0; i < kPerSecond; ++i) {
      geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
      transform.header.frame_id = "frame";
      transform.header.stamp.sec = static_cast<std::uint32_t>(second + 1);
      transform.child_frame_id = "detection_" + std::to_string(second * kPerSecond + i);
      transform.transform.rotation.w = 1;
    }
    ASSERT_TRUE(takeMessage(scene_, "/tf", message, kTime + second * kTime));
  }
  constexpr std::size_t kInTwoMinutes = 120 * kPerSecond;
  EXPECT_LT(scene_.tf().inUse(), TransformBuffer::kKeptFrames + kInTwoMinutes);
  EXPECT_GT(scene_.tf().inUse(), kInTwoMinutes / 2);
}

/// The last test: an interrupt lasts until the program ends.
TEST_F(RecordedSceneTest, AnInterruptEndsAMessageOfMarkers) {
  catchInterrupts();
  EXPECT_TRUE(take(Marker::CUBE, 1000));
  EXPECT_EQ(news_, 1) << "one message";
  EXPECT_EQ(steps_, 1);
  EXPECT_FALSE(take(Marker::MESH_RESOURCE, 2));
  EXPECT_EQ(loads_, 1);
  const int news = news_;
  EXPECT_FALSE(take(Marker::SPHERE, 1000));
  EXPECT_EQ(news_, news);
  EXPECT_EQ(steps_, 1);
}

}  // namespace
}  // namespace link_bounds
