// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// publish() runs on a thread of its own, everything else on the update thread.
#include "node/outputs/stopping_output.h"

#include "node/interface/topics.h"
#include "node/outputs/markers/swept_markers.h"
#include "node/outputs/messages/box_message.h"
#include "world/stopping/stopping_boxes.h"

namespace link_bounds {

StoppingOutput::StoppingOutput(Periodic& periodic, ros::NodeHandle& private_node,
                               const Guard& guard, const SceneCopier& scenes)
    : scenes_(scenes),
      boxes_(private_node, privateName(kStoppingTopic), kBoxesQueue,
             [this, guard](const auto&) { guard([this] { post(); }); }),
      overlaps_(private_node, privateName(kStoppingOverlapsTopic), kBoxesQueue,
                [this, guard](const auto&) { guard([this] { post(); }); }),
      markers_(private_node, privateName(kStoppingMarkersTopic), kMarkersQueue,
               [this, guard](const auto&) { guard([this] { requestMarkers(); }); }),
      markers_output_(
          periodic, guard, [this] { requestMarkers(); }, PacedOutput::kPatienceOfMarkers),
      worker_({"stopping boxes", true}) {}

void StoppingOutput::request() {
  if (markers_.hasSubscribers()) markers_output_.request();
  if (areBoxesWanted()) post();
}

void StoppingOutput::restIfUnheard() {
  if (!areBoxesWanted() && !markers_.hasSubscribers() && !is_resting_.exchange(true))
    worker_.post("boxes", [this] { scenes_.rest(); });
}

void StoppingOutput::requestMarkers() {
  are_markers_due_ = true;
  post();
}

/// The newest boxes are never skipped: while the thread computes, one more publish() waits.
void StoppingOutput::post() {
  is_resting_ = false;
  worker_.post("boxes", [this] { publish(); });
}

/// Publishes nothing if there is no copy of the scene, for example without a robot.
void StoppingOutput::publish() {
  const auto copy = scenes_.copy(worker_);
  if (!copy) return;
  const WayBoxes found = stoppingBoxes(*copy->scene, *copy->rules, copy->states);
  scenes_.setProblem(found.problem);
  fillBoxes(*found.moment, message_);
  boxes_.publish(message_);
  if (are_markers_due_.exchange(false)) markers_.publish(stoppingMarkers(message_));
  if (!overlaps_.hasSubscribers()) return;
  const auto is_over = [this] { return worker_.isStopping(); };
  if (overlap_filler_.fill(found.moment, pairs_, overlaps_message_, is_over))
    overlaps_.publish(overlaps_message_);
}

}  // namespace link_bounds
