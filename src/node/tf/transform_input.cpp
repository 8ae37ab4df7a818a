// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Filters and logs.
#include "node/tf/transform_input.h"

#include <ros/console.h>

#include <algorithm>
#include <iterator>

namespace link_bounds {

void TransformInput::add(const std::vector<TransformView>& transforms, bool is_static,
                         const Publisher& publisher, const ClockWatch& clock, ros::Time now,
                         TransformBuffer& tf) {
  const auto is_late = [&](const TransformView& transform) {
    return clock.isFromBeforeJump(transform.stamp, now);
  };
  if (is_static || std::none_of(transforms.begin(), transforms.end(), is_late)) {
    return addAll(transforms, is_static, publisher, now, tf);
  }
  std::vector<TransformView> kept;
  std::remove_copy_if(transforms.begin(), transforms.end(), std::back_inserter(kept), is_late);
  tf.countDropped(transforms.size() - kept.size());
  addAll(kept, is_static, publisher, now, tf);
}

void TransformInput::addAll(const std::vector<TransformView>& transforms, bool is_static,
                            const Publisher& publisher, ros::Time now, TransformBuffer& tf) {
  for (const Refusal& refusal : tf.add(transforms, is_static, now)) {
    const auto line = log_.line(std::string(transforms[refusal.index].child), refusal.reason,
                                publisher(), ros::SteadyTime::now());
    if (line) ROS_WARN_STREAM(*line);
  }
}

}  // namespace link_bounds
