// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds the transforms of messages to a TransformBuffer.
#pragma once

#include <ros/time.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "world/log/refusal_log.h"
#include "world/tf/clock_watch.h"
#include "world/tf/tf_message.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// By name of a publisher of late transforms, older than the newest one of their frame, so that
/// they do not move it: a text with the delay and the frame of the last one, not sanitised.
using LateTexts = std::map<std::string, std::string>;

class TransformInput {
 public:
  /// The name of the node that sent the message; called at most once for each message.
  using Publisher = std::function<std::string()>;

  /// Adds the transforms of a message at time `now`, except those that were sent before the clock
  /// jumped back, see ClockWatch::isFromBeforeJump(). Logs refused and late transforms.
  void add(const std::vector<TransformView>& transforms, bool is_static, const Publisher& publisher,
           const ClockWatch& clock, ros::Time now, ros::SteadyTime arrival, TransformBuffer& tf);

  /// The publishers that were late in the last five seconds. Forgets the others.
  LateTexts takeLatePublishers();

  /// Lines that were logged may be logged again.
  void forgetLog();

 private:
  struct Lateness {
    std::string frame;
    double behind;  ///< [s]
    ros::SteadyTime time;
  };

  void addAll(const std::vector<TransformView>& transforms, bool is_static,
              const Publisher& publisher, ros::Time now, TransformBuffer& tf);

  void report(const std::vector<Refusal>& refusals, const std::vector<TransformView>& transforms,
              const std::string& publisher);

  RefusalLog log_{"a transform of", "transforms of further frames"};
  RefusalLog late_log_{"a transform of", "transforms of further frames", "late"};
  RefusalLog doubt_log_{"a transform of", "transforms of further frames", "in doubt"};
  std::map<std::string, Lateness> late_publishers_;  ///< by name; does not grow with the frames
};

}  // namespace link_bounds
