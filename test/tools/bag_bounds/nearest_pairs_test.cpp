// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// wasInterrupted() after a step that was interrupted.
#include "tools/bag_bounds/watch/nearest_pairs.h"

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <csignal>

#include "testing/live_boxes_testing.h"
#include "testing/marker_testing.h"
#include "testing/recorded_testing.h"
#include "tools/bag_bounds/scene/recorded_scene.h"
#include "tools/command_line/interrupt.h"

namespace link_bounds {
namespace {

/// A cube that stands, and one that passes through it between two messages.
class NearestPairsTest : public testing::Test {
 protected:
  NearestPairsTest() {
    auto model = std::make_shared<Model>(*modelOf("frame", {}));
    model->parameters.distance_limit = 0.1;
    scene_.adopt(model, kTime);
    visualization_msgs::MarkerArray array;
    for (int i = 0; i < 2; ++i) {
      array.markers.push_back(markerOf(visualization_msgs::Marker::CUBE, {1, 1, 1}));
      array.markers.back().id = i;
    }
    array.markers.back().header.frame_id = "moving";
    takeMessage(scene_, "/objects", array, kTime);
  }

  void move(double x, double stamp) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(
        edge("frame", "moving", stamp, Eigen::Quaterniond::Identity(), {x, 0, 0}));
    const auto now = static_cast<std::int64_t>(stamp * 1e9);
    takeMessage(scene_, "/tf", message, now);
    pairs_.add(scene_.scene(), scene_.tf(), now);
  }

  static constexpr std::int64_t kTime = 1'000'000'000;  // ns

  RecordedScene scene_{[](const std::string&) { return LoadedMesh(); }, [](std::int64_t) {},
                       [](std::int64_t, bool) {}};
  NearestPairs pairs_{[](const std::string&) { return LoadedTree(); }};
};

TEST_F(NearestPairsTest, AContactBetweenTwoMessagesIsFound) {
  move(-5, 1);
  move(5, 1.5);
  EXPECT_TRUE(pairs_.wasUndercut());
  EXPECT_FALSE(pairs_.wasInterrupted());
}

/// The last test: an interrupt lasts until the program ends.
TEST_F(NearestPairsTest, AStepThatWasInterruptedIsTold) {
  catchInterrupts();
  move(-5, 1);
  EXPECT_FALSE(pairs_.wasInterrupted());
  std::raise(SIGINT);
  move(5, 1.5);
  EXPECT_FALSE(pairs_.wasUndercut());
  EXPECT_TRUE(pairs_.wasInterrupted());
}

}  // namespace
}  // namespace link_bounds
