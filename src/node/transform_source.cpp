// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Feeds tf2 and the frame tree side by side.
#include "transform_source.h"

#include <tf2/exceptions.h>

namespace link_bounds {
namespace {

/// The number of a frame as it is written in a message; tf2 strips one slash as well.
FrameTree::Frame frameOf(FrameTree& tree, const std::string& name) {
  if (!name.empty() && name.front() == '/') return tree.frame(name.substr(1));
  return tree.frame(name);
}

Eigen::Isometry3d toIsometry(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  const auto& t = transform.translation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  result.translation() = Eigen::Vector3d(t.x, t.y, t.z);
  return result;
}

}  // namespace

void TransformSource::add(const std::vector<geometry_msgs::TransformStamped>& transforms,
                          bool is_static, ros::Time now) {
  tree_.beginMessage();
  for (const geometry_msgs::TransformStamped& transform : transforms) {
    if (!buffer_.setTransform(transform, "link_bounds", is_static)) continue;
    tree_.heard(frameOf(tree_, transform.child_frame_id), frameOf(tree_, transform.header.frame_id),
                is_static, static_cast<std::int64_t>(transform.header.stamp.toNSec()),
                static_cast<std::int64_t>(now.toNSec()));
  }
}

std::optional<StampedPose> TransformSource::latest(const std::string& target,
                                                   const std::string& source) const {
  try {
    const geometry_msgs::TransformStamped transform =
        buffer_.lookupTransform(target, source, ros::Time(0));
    return StampedPose{toIsometry(transform.transform),
                       static_cast<std::int64_t>(transform.header.stamp.toNSec())};
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

void TransformSource::clear() {
  buffer_.clear();
  tree_.forgetDynamic();
}

}  // namespace link_bounds
