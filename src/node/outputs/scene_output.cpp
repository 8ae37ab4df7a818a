// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and groups are always published, everything else only to subscribers.
#include "node/outputs/scene_output.h"

#include <algorithm>

#include "node/outputs/box_message.h"
#include "node/outputs/footprint.h"

namespace link_bounds {
namespace {

/// In messages per subscriber; the kernel buffers about as many again. Long enough for a subscriber
/// on a busy machine, and short enough to bound the memory that a stopped subscriber takes.
constexpr std::uint32_t kBoxesQueue = 200;
constexpr std::uint32_t kMarkersQueue = 10;
constexpr std::uint32_t kFootprintQueue = 10;

}  // namespace

SceneOutput::SceneOutput(ros::NodeHandle& node, ros::NodeHandle& private_node, const Scene& scene,
                         const Guard& guard, TreeRequests requests)
    : scene_(scene),
      boxes_publisher_(
          private_node.advertise<AxisAlignedBoxArray>(privateName(kBoxesTopic), kBoxesQueue, true)),
      groups_publisher_(private_node.advertise<AxisAlignedBoxArray>(privateName(kGroupsTopic),
                                                                    kBoxesQueue, true)),
      markers_(private_node, kMarkersTopic, kMarkersQueue, guard,
               [this](auto& message, Audience audience) { return fillMarkers(message, audience); }),
      parts_(private_node, kPartsTopic, kBoxesQueue, guard,
             [this](auto& message, Audience) { return fillParts(message); }),
      footprint_(private_node, kFootprintTopic, kFootprintQueue, guard,
                 [this](auto& message, Audience) { return fillFootprint(message); }),
      overlaps_(private_node, kOverlapsTopic, kBoxesQueue, guard,
                [this](auto& message, Audience) { return fillOverlaps(message); }),
      boxes_output_(node, guard, [this] { publishBoxes(); }),
      markers_output_(node, guard, [this] { markers_.publish(); }),
      distances_(private_node, guard, std::move(requests), [this] {
        if (!boxes_output_.isWaiting()) giveDistances();
      }) {}

void SceneOutput::adopt() {
  const Parameters& parameters = scene_.model()->parameters;
  part_boxes_.adopt(*scene_.model());
  distances_.adopt(parameters);
  boxes_output_.setRate(parameters.max_rate);
  markers_output_.setRate(parameters.marker_rate);
  boxes_output_.emitNow();
  markers_output_.request();
}

void SceneOutput::request() {
  boxes_output_.request();
  if (markers_.hasSubscribers()) markers_output_.request();
}

void SceneOutput::freeSpareMemory() {
  scene_overlaps_ = SceneOverlaps();
  overlaps_.freeSpareMemory();
}

std::string SceneOutput::footprintState() const {
  const std::string reason = whyNoFootprint(groups_message_);
  if (!reason.empty()) return "silent: " + reason;
  return footprint_.hasSubscribers() ? "published" : "silent: nobody subscribes";
}

void SceneOutput::publishBoxes() {
  ++publications_;
  fillBoxes(scene_, boxes_message_);
  boxes_publisher_.publish(boxes_message_);
  recordLag(boxes_message_.header.stamp);
  fillGroups(scene_, groups_message_);
  groups_publisher_.publish(groups_message_);
  rememberLinks();
  parts_.publish();
  footprint_.publish();
  overlaps_.publish();
  if (distances_.isWanted()) giveDistances();
  on_boxes_();
}

/// The scene must be that of the last ~boxes.
void SceneOutput::giveDistances() {
  if (publications_ > 0) distances_.give(takeSnapshot(scene_, boxes_message_));
}

/// What overlaps and parts need besides the messages.
void SceneOutput::rememberLinks() {
  const std::vector<BoxState>& links = scene_.links.states();
  boxed_links_.clear();
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].box) boxed_links_.push_back(i);
  }
  part_boxes_.place(scene_.links);
}

void SceneOutput::recordLag(ros::Time stamp) {
  if (stamp.isZero()) return;
  const double lag = (ros::Time::now().toSec() - stamp.toSec()) * 1e3;
  lag_ms_ = std::max(lag, lag_ms_.value_or(lag));
}

/// A message to a new subscriber must not forget the markers that others may still show.
bool SceneOutput::fillMarkers(visualization_msgs::MarkerArray& message, Audience audience) {
  if (!scene_.model()) return false;
  const std_msgs::Header header = headerOf(scene_);
  message = boxMarkers(scene_, header);
  if (audience == Audience::kAll) {
    shown_.replaceBy(message, header);
  } else {
    shown_.extendBy(message, header);
  }
  return true;
}

bool SceneOutput::fillParts(AxisAlignedBoxArray& message) {
  if (!part_boxes_.areWanted()) return false;
  part_boxes_.fill(*scene_.model(), message);
  return true;
}

bool SceneOutput::fillFootprint(geometry_msgs::Polygon& message) const {
  const auto footprint = footprintOf(groups_message_);
  if (footprint) message = *footprint;
  return footprint.has_value();
}

bool SceneOutput::fillOverlaps(BoxOverlapArray& message) {
  if (publications_ == 0) return false;
  scene_overlaps_.fill(*scene_.model(), boxes_message_, boxed_links_, message);
  return true;
}

}  // namespace link_bounds
