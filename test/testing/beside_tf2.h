// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The same transforms in tf2 and in our buffer, and what tf2 makes of them.
#pragma once

#include <console_bridge/console.h>
#include <gtest/gtest.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "testing/random_tf.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

inline constexpr double kSame = 1e-12;  // of 1 m or the distance, and of the entries of a rotation

class BesideTf2 {
 public:
  BesideTf2() { console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE); }

  void add(const RandomMessage& message) {
    for (const auto& transform : message.transforms) {
      tf2.setTransform(transform, "test", message.is_static);
      stamps_.push_back(static_cast<std::int64_t>(transform.header.stamp.toNSec()));
    }
    ours.add({message.transforms.begin(), message.transforms.end()}, message.is_static,
             ros::Time(1));
  }

  /// The stamp of one of the last 100 or 3000 transforms [ns]. Nothing before the first.
  std::optional<std::int64_t> pickStamp(RandomTf& random) const {
    const auto recent = std::min<std::size_t>(stamps_.size(), random.pick(2) ? 100 : 3000);
    if (recent == 0) return std::nullopt;
    const int age = random.pick(static_cast<int>(recent));
    return stamps_[stamps_.size() - 1 - static_cast<std::size_t>(age)];
  }

  /// As tf2 looks it up, but as if nothing were above the nearest frame above both: uneven
  /// quaternions there scale poses in tf2 alone. Nothing where tf2 throws. Time 0: the latest.
  std::optional<geometry_msgs::TransformStamped> lookUp(const std::string& target,
                                                        const std::string& source,
                                                        ros::Time time) const {
    try {
      auto result = tf2.lookupTransform(target, source, time);
      time = result.header.stamp;
      const std::string top = meetingPoint(target, source, time);
      if (top == target || top == source) return result;
      const Tf2Pose pose = inverse(poseOf(tf2.lookupTransform(top, target, time))) *
                           poseOf(tf2.lookupTransform(top, source, time));
      std::memcpy(static_cast<void*>(&result.transform), pose.numbers.data(), sizeof(pose.numbers));
      return result;
    } catch (const tf2::TransformException&) {
      return std::nullopt;
    }
  }

  tf2::BufferCore tf2;
  TransformBuffer ours;

 private:
  static Tf2Pose poseOf(const geometry_msgs::TransformStamped& transform) {
    return TransformView(transform).parent_from_child;
  }

  /// The target if it is above the source at that time, else the nearest frame above both, which
  /// may be the source.
  std::string meetingPoint(const std::string& target, const std::string& source,
                           ros::Time time) const {
    std::set<std::string> way{source};
    std::string frame = source;
    while (frame != target && tf2._getParent(frame, time, frame))
      way.insert(frame);
    frame = target;
    while (way.count(frame) == 0 && tf2._getParent(frame, time, frame)) {
    }
    return frame;
  }

  std::vector<std::int64_t> stamps_;  ///< of all transforms, in the order of their receipt [ns]
};

inline Eigen::Isometry3d toIsometry(const geometry_msgs::TransformStamped& transform) {
  const auto& q = transform.transform.rotation;
  const auto& t = transform.transform.translation;
  return Eigen::Translation3d(t.x, t.y, t.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

inline void expectSame(const Eigen::Affine3d& pose,
                       const geometry_msgs::TransformStamped& transform) {
  const Eigen::Isometry3d expected = toIsometry(transform);
  EXPECT_LT((pose.translation() - expected.translation()).norm(),
            kSame * std::max(1.0, expected.translation().norm()));
  EXPECT_LT((pose.linear() - expected.linear()).norm(), kSame);
}

}  // namespace link_bounds
