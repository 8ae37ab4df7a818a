// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// publish() runs on the history thread, everything else on the update thread.
#include "node/outputs/swept_output.h"

#include <ros/single_subscriber_publisher.h>

#include <algorithm>

#include "node/names/topics.h"
#include "node/outputs/past_message.h"
#include "node/outputs/swept_markers.h"
#include "node/threads/queued_function.h"

namespace link_bounds {
namespace {

/// As in scene_output.cpp.
constexpr std::uint32_t kBoxesQueue = 200;
constexpr std::uint32_t kMarkersQueue = 10;

/// More than all history; larger numbers would overflow.
constexpr double kMaxSpan = 1e6;  // s

std::int64_t spanOf(const Parameters& parameters) {
  return static_cast<std::int64_t>(std::min(parameters.swept_span, kMaxSpan) * 1e9);
}

template <class Message>
ros::Publisher advertise(ros::NodeHandle& node, const TopicName& topic, std::uint32_t queue,
                         const std::function<void()>& on_subscriber) {
  return node.advertise<Message>(
      privateName(topic), queue,
      [on_subscriber](const ros::SingleSubscriberPublisher&) { on_subscriber(); });
}

}  // namespace

SweptOutput::SweptOutput(ros::NodeHandle& node, ros::NodeHandle& private_node, const Guard& guard,
                         HistoryThread& history)
    : history_(history),
      publisher_(advertise<AxisAlignedBoxArray>(private_node, kSweptTopic, kBoxesQueue,
                                                [this, guard] { guard([&] { request(); }); })),
      markers_publisher_(advertise<visualization_msgs::MarkerArray>(
          private_node, kSweptMarkersTopic, kMarkersQueue,
          [this, guard] { guard([&] { requestMarkers(); }); })),
      markers_output_(node, guard, [this] { requestMarkers(); }) {}

void SweptOutput::adopt(const Parameters& parameters) {
  const bool ends = span_ > 0 && parameters.swept_span == 0;
  span_ = spanOf(parameters);
  markers_output_.setRate(parameters.marker_rate);
  if (ends) enqueue(history_.queue(), [this] { markers_publisher_.publish(sweptMarkers({})); });
}

void SweptOutput::request() {
  if (span_ == 0) return;
  if (publisher_.getNumSubscribers() > 0) enqueueUnlessWaiting();
  if (markers_publisher_.getNumSubscribers() > 0) markers_output_.request();
}

void SweptOutput::requestMarkers() {
  are_markers_due_ = true;
  enqueueUnlessWaiting();
}

void SweptOutput::enqueueUnlessWaiting() {
  if (span_ > 0 && !is_waiting_.exchange(true)) enqueue(history_.queue(), [this] { publish(); });
}

/// From here on another call may wait, so that the newest boxes are never left out.
void SweptOutput::publish() {
  is_waiting_ = false;
  const bool are_markers_due = are_markers_due_.exchange(false);
  BoxRequest request;
  request.span = span_;
  if (request.span == 0 || !history_.model()) return;
  const std::unique_ptr<PastScene> scene = history_.copy(request);
  if (!scene || !whyRefused(*scene).empty()) return;
  const PastBoxes boxes = pastBoxes(*scene, request, [this] { return history_.isStopping(); });
  if (history_.isStopping()) return;
  fillBoxes(*scene, boxes, request, message_);
  publisher_.publish(message_);
  if (are_markers_due) markers_publisher_.publish(sweptMarkers(message_));
}

}  // namespace link_bounds
