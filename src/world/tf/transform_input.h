// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds the transforms of messages to a TransformBuffer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "world/log/refusal_log.h"
#include "world/tf/clock_watch.h"
#include "world/tf/late_publishers.h"
#include "world/tf/tf_message.h"
#include "world/tf/transform_buffer.h"

namespace link_bounds {

class TransformInput {
 public:
  /// The name of the node that sent the message; called at most once for each message.
  using Publisher = std::function<std::string()>;

  /// Adds the transforms of a message at time `now`, except those that were sent before the clock
  /// jumped back, see ClockWatch::isFromBeforeJump(). Logs refused and late transforms.
  void add(const std::vector<TransformView>& transforms, bool is_static, const Publisher& publisher,
           const ClockWatch& clock, ros::Time now, ros::SteadyTime arrival, TransformBuffer& tf);

  /// The publishers of late transforms; see LatePublishers.
  LatePublishers::Texts takeLatePublishers() {
    return late_publishers_.take(ros::SteadyTime::now());
  }

  /// Lines that were logged may be logged again.
  void forgetLog();

 private:
  void addAll(const std::vector<TransformView>& transforms, bool is_static,
              const Publisher& publisher, ros::Time now, TransformBuffer& tf);

  void report(const std::vector<Refusal>& refusals, const std::vector<TransformView>& transforms,
              const std::string& publisher);

  RefusalLog log_{"a transform of", "transforms of further frames"};
  RefusalLog late_log_{"a transform of", "transforms of further frames", "late"};
  RefusalLog doubt_log_{"a transform of", "transforms of further frames", "in doubt"};
  LatePublishers late_publishers_;
};

}  // namespace link_bounds
