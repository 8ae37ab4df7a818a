// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the transforms of a message into a TransformBuffer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "node/clock/clock_watch.h"
#include "node/log/refusal_log.h"
#include "node/tf/tf_message.h"
#include "node/tf/transform_buffer.h"

namespace link_bounds {

class TransformInput {
 public:
  /// The name of the node that sent the message; called only where a log line needs it.
  using Publisher = std::function<std::string()>;

  /// Adds the transforms of a message that arrived at `now`, without those that were sent before
  /// the clock jumped back. Logs what tf refuses.
  void add(const std::vector<TransformView>& transforms, bool is_static, const Publisher& publisher,
           const ClockWatch& clock, ros::Time now, TransformBuffer& tf);

  /// What was logged may be logged again.
  void forgetLog() { log_.forget(); }

 private:
  void addAll(const std::vector<TransformView>& transforms, bool is_static,
              const Publisher& publisher, ros::Time now, TransformBuffer& tf);

  RefusalLog log_{"a transform of", "transforms of further frames"};
};

}  // namespace link_bounds
