// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// publish() and forget() run on a thread of their own.
#include "node/outputs/earliest_output.h"

#include <utility>

#include "node/interface/topics.h"

namespace link_bounds {

EarliestOutput::EarliestOutput(ros::NodeHandle& private_node, const Guard& guard,
                               const SceneCopier& scenes, TreeRequests requests)
    : scenes_(scenes),
      contacts_(std::move(requests)),
      output_(private_node, privateName(kEarliestTopic), kBoxesQueue,
              [this, guard](const auto&) { guard([this] { request(); }); }),
      worker_({"earliest contacts", true}) {}

/// The newest boxes are never skipped: while the thread computes, one more publish() waits.
void EarliestOutput::request() {
  if (output_.hasSubscribers()) {
    is_forgotten_ = false;
    worker_.post("contacts", [this] { publish(); });
  }
}

void EarliestOutput::restIfUnheard() {
  if (!output_.hasSubscribers() && !is_forgotten_.exchange(true))
    worker_.post("contacts", [this] { forget(); });
}

/// The next computation uses the tree.
void EarliestOutput::give(MadeTree tree) {
  worker_.post([this, tree = std::move(tree)] { contacts_.trees().add(tree); });
}

void EarliestOutput::publish() {
  const auto copy = scenes_.copy(worker_);
  if (!copy) return;
  const auto now = std::chrono::steady_clock::now();
  const auto is_over = [this] { return worker_.isStopping(); };
  const auto computed = contacts_.compute(*copy->scene, *copy->rules, copy->states, now, is_over);
  if (!computed) return;
  contacts_.trees().requestSettled(now);
  scenes_.setProblem(computed->problem);
  output_.publish(computed->array);
}

void EarliestOutput::forget() {
  scenes_.rest();
  contacts_.forget();
}

}  // namespace link_bounds
