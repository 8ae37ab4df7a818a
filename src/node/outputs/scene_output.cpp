// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes and groups are always published, everything else only for subscribers.
#include "node/outputs/scene_output.h"

#include <algorithm>
#include <utility>

#include "node/outputs/messages/box_message.h"
#include "node/outputs/messages/footprint.h"

namespace link_bounds {

SceneOutput::SceneOutput(Periodic& periodic, ros::NodeHandle& private_node, const Scene& scene,
                         const Guard& guard, TreeRequests requests)
    : scene_(scene),
      boxes_(private_node, privateName(kBoxesTopic), kBoxesQueue,
             Output<AxisAlignedBoxArray>::Latched()),
      groups_(private_node, privateName(kGroupsTopic), kBoxesQueue,
              Output<AxisAlignedBoxArray>::Latched()),
      footprint_(private_node, privateName(kFootprintTopic), kFootprintQueue,
                 [this, guard](const auto& subscriber) {
                   guard([&] { greetWithFootprint(*subscriber); });
                 }),
      boxes_output_(periodic, guard, [this] { publishBoxes(); }),
      markers_output_(
          periodic, guard, [this] { giveMarkers(); }, PacedOutput::kPatienceOfMarkers),
      optional_(private_node, guard, pairs_,
                {[this] { return published(); }, [this] { return current(); }}),
      distances_(private_node, guard, std::move(requests), pairs_, [this] { giveDistances(); }) {}

void SceneOutput::adopt() {
  const Parameters& parameters = scene_.model()->parameters;
  moment_ = nullptr;
  distances_.adopt(parameters);
  optional_.adopt();
  boxes_output_.setRate(parameters.max_rate);
  markers_output_.setRate(parameters.marker_rate);
  boxes_output_.emitNow();
  if (optional_.areMarkersWanted()) markers_output_.request();
}

void SceneOutput::request() {
  moment_ = nullptr;
  boxes_output_.request();
  if (optional_.areMarkersWanted()) markers_output_.request();
}

std::string SceneOutput::footprintState() const {
  const std::string reason = whyNoFootprint(groups_message_);
  if (!reason.empty()) return "silent: " + reason;
  return footprint_.hasSubscribers() ? "published" : "silent: nobody subscribes";
}

void SceneOutput::publishBoxes() {
  fillBoxes(scene_, boxes_message_);
  boxes_.publish(boxes_message_);
  ++publications_;
  recordLag(boxes_message_.header.stamp);
  fillGroups(scene_, groups_message_);
  groups_.publish(groups_message_);
  publishFootprint();
  published_ = nullptr;
  if (boxes_output_.isLimited()) published_ = current();
  expectPairs();
  giveBoxes();
  giveDistances();
  on_boxes_();
}

void SceneOutput::publishFootprint() {
  if (!footprint_.hasSubscribers()) return;
  if (const auto footprint = footprintOf(groups_message_)) footprint_.publish(*footprint);
}

void SceneOutput::greetWithFootprint(OutputTopic::Subscriber& subscriber) {
  if (const auto footprint = footprintOf(groups_message_))
    footprint_.publishTo(subscriber, *footprint);
}

/// The moment of the last ~boxes; null before the first. Without a limit of the rate, the scene has
/// not changed since.
MomentPtr SceneOutput::published() {
  if (publications_ > 0 && !published_) published_ = current();
  return published_;
}

/// The moment of the scene as it is; null before the first model.
MomentPtr SceneOutput::current() {
  if (!moment_ && scene_.model()) moment_ = momentOf(scene_);
  return moment_;
}

/// To be called before the threads get the moment, so that the first thread searches for all.
void SceneOutput::expectPairs() {
  const Parameters& parameters = scene_.model()->parameters;
  const double overlaps = optional_.areOverlapsWanted() ? parameters.overlap_margin : 0;
  pairs_.expect(std::max(overlaps, distances_.isWanted() ? parameters.distance_limit : 0));
}

void SceneOutput::giveBoxes() {
  if (optional_.areWanted()) optional_.give(published());
}

void SceneOutput::giveDistances() {
  if (publications_ > 0 && distances_.isWanted()) distances_.give(published());
}

void SceneOutput::giveMarkers() {
  if (const auto moment = current()) optional_.giveMarkers(moment);
}

/// When the newest body goes, the stamp gets older; that is no lag.
void SceneOutput::recordLag(ros::Time stamp) {
  if (stamp.isZero() || stamp <= std::exchange(last_stamp_, stamp)) return;
  const double lag = (ros::Time::now().toSec() - stamp.toSec()) * 1e3;
  lag_ms_ = std::max(lag, lag_ms_.value_or(lag));
}

}  // namespace link_bounds
