// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// publish() runs on a thread of its own, everything else on the update thread.
#include "node/outputs/swept_output.h"

#include <algorithm>

#include "node/interface/topics.h"
#include "node/outputs/markers/swept_markers.h"
#include "node/outputs/messages/box_message.h"
#include "world/history/past_boxes.h"

namespace link_bounds {
namespace {

/// Longer than any history; much larger spans would overflow.
constexpr double kMaxSpan = 1e6;  // s

std::int64_t spanOf(const Parameters& parameters) {
  return static_cast<std::int64_t>(std::min(parameters.swept_span, kMaxSpan) * 1e9);
}

}  // namespace

SweptOutput::SweptOutput(Periodic& periodic, ros::NodeHandle& private_node, const Guard& guard,
                         const SceneCopier& scenes)
    : scenes_(scenes),
      boxes_(private_node, privateName(kSweptTopic), kBoxesQueue,
             [this, guard](const auto&) { guard([this] { request(); }); }),
      markers_(private_node, privateName(kSweptMarkersTopic), kMarkersQueue,
               [this, guard](const auto&) { guard([this] { requestMarkers(); }); }),
      markers_output_(
          periodic, guard, [this] { requestMarkers(); }, PacedOutput::kPatienceOfMarkers),
      worker_({"swept boxes", true}) {}

void SweptOutput::adopt(const Parameters& parameters) {
  const bool ends = span_ > 0 && parameters.swept_span == 0;
  span_ = spanOf(parameters);
  markers_output_.setRate(parameters.marker_rate);
  if (ends) worker_.post("end", [this] { markers_.publish(sweptMarkers({})); });
}

void SweptOutput::request() {
  if (span_ == 0) return;
  if (markers_.hasSubscribers()) markers_output_.request();
  if (boxes_.hasSubscribers()) postBoxes();
}

void SweptOutput::requestMarkers() {
  are_markers_due_ = true;
  postBoxes();
}

/// The newest boxes are never skipped: while the thread computes, one more publish() waits.
void SweptOutput::postBoxes() {
  if (span_ > 0) worker_.post("boxes", [this] { publish(); });
}

void SweptOutput::publish() {
  BoxRequest request;
  request.span = span_;
  if (request.span == 0 || !scenes_.model()) return;
  const std::unique_ptr<PastScene> scene = scenes_.copy(worker_, request);
  if (!scene || !whyRefused(*scene).empty()) return;
  const PastBoxes boxes = pastBoxes(*scene, request, [this] { return worker_.isStopping(); });
  if (worker_.isStopping()) return;
  fillBoxes(boxes.moment, message_);
  boxes_.publish(message_);
  if (are_markers_due_.exchange(false)) markers_.publish(sweptMarkers(message_));
}

}  // namespace link_bounds
