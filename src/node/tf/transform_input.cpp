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
  for (const Refusal& refusal : tf.add(transforms, is_static, now))
    report(refusal, transforms[refusal.index], publisher());
}

void TransformInput::report(const Refusal& refusal, const TransformView& transform,
                            const std::string& publisher) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  std::string reason = refusal.reason;
  if (refusal.behind) {
    late_publishers_.add(publisher, transform.child, *refusal.behind, now);
    reason = "it is " + std::to_string(*refusal.behind) + " s behind: " + reason;
  }
  RefusalLog& log = refusal.is_accepted ? late_log_ : log_;
  if (const auto line = log.line(std::string(transform.child), reason, publisher, now))
    ROS_WARN_STREAM(*line);
}

void TransformInput::forgetLog() {
  log_.forget();
  late_log_.forget();
  late_publishers_.clear();
}

}  // namespace link_bounds
