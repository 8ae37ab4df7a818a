// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// publish() and publishDueMarkers() run on the thread of distances.
#include "node/outputs/distance_output.h"

#include <utility>

#include "node/outputs/markers/distance_markers.h"

namespace link_bounds {

DistanceOutput::DistanceOutput(ros::NodeHandle& private_node, const Guard& guard,
                               TreeRequests requests, MomentPairs& pairs,
                               std::function<void()> send)
    : guard_(guard),
      send_(std::move(send)),
      distances_(private_node, privateName(kDistancesTopic), kBoxesQueue,
                 [this](const auto&) { guard_(send_); }),
      nearest_(private_node, privateName(kNearestTopic), kBoxesQueue,
               [this](const auto&) { guard_(send_); }),
      markers_(private_node, privateName(kDistanceMarkersTopic), kMarkersQueue,
               [this](const auto&) { guard_(send_); }),
      thread_(std::move(requests), pairs,
              {[this](ComputedDistances computed) { publish(std::move(computed)); },
               [this] { publishDueMarkers(); }, [this] { return isWanted(); }}) {}

bool DistanceOutput::isWanted() const {
  return warning_ > 0 || distances_.hasSubscribers() || nearest_.hasSubscribers() ||
         markers_.hasSubscribers();
}

void DistanceOutput::publish(ComputedDistances computed) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    health_.pairs = computed.array.distances.size();
    health_.levels = computed.levels;
    health_.left_out = computed.left_out;
    health_.nearest = computed.nearest;
  }
  distances_.publish(computed.array);
  nearest_.publish(computed.nearest);
  if (markers_.hasSubscribers()) unmarked_ = std::move(computed);
}

void DistanceOutput::publishDueMarkers() {
  if (!unmarked_) return;
  const Parameters& parameters = unmarked_->moment->model->parameters;
  const Time now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - last_markers_).count() < 1 / parameters.marker_rate)
    return;
  last_markers_ = now;
  markers_.publish(distanceMarkers(unmarked_->array, unmarked_->nearest,
                                   parameters.distance_warning, parameters.distance_limit));
  unmarked_.reset();
}

DistanceHealth DistanceOutput::takeHealth() {
  const std::lock_guard<std::mutex> lock(mutex_);
  health_.is_wanted = isWanted();
  if (!health_.is_wanted) health_ = DistanceHealth();
  DistanceHealth health = health_;
  health.behind = thread_.behind();
  health.times = thread_.takeTimes();
  health.errors = thread_.errors();
  return health;
}

}  // namespace link_bounds
