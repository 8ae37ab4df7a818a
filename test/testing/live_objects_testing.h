// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects made by hand in a tf of the test's own.
#pragma once

#include <gtest/gtest.h>

#include "testing/live_boxes_testing.h"
#include "world/bodies/live_objects.h"

namespace link_bounds {

inline constexpr double kTolerance = 1e-12;  // metres
inline const ObjectKey kKey{"scene", 1};

inline Eigen::Quaterniond turnedBy(double degrees) {
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(degrees / 180 * M_PI, Eigen::Vector3d(1, 2, 3).normalized()));
}

/// A box of 1 x 2 x 3 m.
inline ObjectContent boxIn(const std::string& frame, double stamp = 0) {
  ObjectContent content;
  content.bounded.name = "scene/1";
  content.bounded.shapes = {{nullptr, Solid::kBox, {1, 2, 3}, Eigen::Affine3d::Identity()}};
  content.frame = frame;
  content.stamp = static_cast<std::int64_t>(stamp * 1e9);
  return content;
}

inline ObjectContent meshOf(const std::string& uri) {
  ObjectContent content = boxIn("map");
  content.bounded.shapes.front().solid = Solid::kNone;
  content.mesh_uri = uri;
  return content;
}

inline LoadedMesh loadedMesh() {
  brute_force::Random random(1);
  return {std::make_shared<const PointSet>(random.points(30, 0.5)), ""};
}

class LiveObjectsTest : public testing::Test {
 protected:
  LiveObjectsTest() { adopt("map", 2); }

  void adopt(const std::string& fixed_frame, double timeout) {
    frames_.setTarget(fixed_frame, timeout, now_);
    objects_.adopt(now_);
  }

  bool put(const ObjectContent& content) { return objects_.put(kKey, content, now_); }

  bool update() {
    frames_.update(now_);
    return objects_.update(now_);
  }

  bool expire() {
    frames_.expire(now_);
    return objects_.expire(now_);
  }

  bool restart() {
    frames_.updateAll(now_);
    return objects_.restart(now_);
  }

  bool hear(const std::string& parent, const std::string& child, double stamp, double degrees,
            double x = 0) {
    tf_.add({edge(parent, child, stamp, turnedBy(degrees), {x, 0, 0})}, false, now_);
    return update();
  }

  bool pass(double seconds) {
    now_ += ros::Duration(seconds);
    return expire();
  }

  const LiveObject& object() const { return objects_.objects().at(kKey); }
  const BoxState& state() const { return object().state; }

  /// The box of the 1 x 2 x 3 m box, turned, then moved along x.
  void expectBox(double degrees, double x = 0) const {
    ASSERT_TRUE(state().box);
    const Eigen::Vector3d radius =
        turnedBy(degrees).toRotationMatrix().cwiseAbs() * Eigen::Vector3d(0.5, 1, 1.5);
    const Eigen::Vector3d center(x, 0, 0);
    EXPECT_LT((state().box->min() - (center - radius)).norm(), kTolerance);
    EXPECT_LT((state().box->max() - (center + radius)).norm(), kTolerance);
  }

  ros::Time now_{100};
  TransformBuffer tf_;
  FrameTracker frames_{tf_};
  LiveObjects objects_{frames_};
};

}  // namespace link_bounds
