// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/tf/transform_input.h"

#include <ros/console.h>

#include <algorithm>
#include <string_view>

namespace link_bounds {
namespace {

const ros::WallDuration kMemory(5.0);

std::string reasonOf(const Refusal& refusal) {
  if (!refusal.behind) return refusal.reason;
  return "it is " + std::to_string(*refusal.behind) + " s behind: " + refusal.reason;
}

}  // namespace

void TransformInput::add(const std::vector<TransformView>& transforms, bool is_static,
                         const Publisher& publisher, const ClockWatch& clock, ros::Time now,
                         ros::SteadyTime arrival, TransformBuffer& tf) {
  const auto is_late = [&](const TransformView& transform) {
    return clock.isFromBeforeJump(transform.stamp, now, arrival);
  };
  if (is_static || std::none_of(transforms.begin(), transforms.end(), is_late)) {
    return addAll(transforms, is_static, publisher, now, tf);
  }
  std::vector<TransformView> kept;
  for (const TransformView& transform : transforms) {
    if (is_late(transform)) {
      tf.countDropped(transform);
    } else {
      kept.push_back(transform);
    }
  }
  addAll(kept, is_static, publisher, now, tf);
}

void TransformInput::addAll(const std::vector<TransformView>& transforms, bool is_static,
                            const Publisher& publisher, ros::Time now, TransformBuffer& tf) {
  const std::vector<Refusal> refusals = tf.add(transforms, is_static, now);
  if (!refusals.empty()) report(refusals, transforms, publisher());
}

/// A late publisher sends thousands of late transforms. So a text is made only for lines that are
/// logged.
void TransformInput::report(const std::vector<Refusal>& refusals,
                            const std::vector<TransformView>& transforms,
                            const std::string& publisher) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const Refusal* late = nullptr;
  for (const Refusal& refusal : refusals) {
    if (refusal.behind) late = &refusal;
    RefusalLog& log = !refusal.is_accepted ? log_ : refusal.behind ? late_log_ : doubt_log_;
    const std::string_view frame = transforms[refusal.index].child;
    if (log.isQuiet(frame, now)) continue;
    if (const auto line = log.line(std::string(frame), reasonOf(refusal), publisher, now))
      ROS_WARN_STREAM(*line);
  }
  if (late)
    late_publishers_[publisher] = {std::string(transforms[late->index].child), *late->behind, now};
}

LateTexts TransformInput::takeLatePublishers() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  LateTexts texts;
  for (auto entry = late_publishers_.begin(); entry != late_publishers_.end();) {
    const auto& [publisher, lateness] = *entry;
    if (now - lateness.time > kMemory) {
      entry = late_publishers_.erase(entry);
      continue;
    }
    texts[publisher] =
        "by " + std::to_string(lateness.behind) + " s (frame " + lateness.frame + ")";
    ++entry;
  }
  return texts;
}

void TransformInput::forgetLog() {
  log_.forget();
  late_log_.forget();
  doubt_log_.forget();
  late_publishers_.clear();
}

}  // namespace link_bounds
