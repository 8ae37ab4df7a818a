// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One work per topic waits at most: that of the newest snapshot.
#include "node/outputs/optional_outputs.h"

#include <utility>

#include "node/interface/topics.h"
#include "node/outputs/queues.h"

namespace link_bounds {
namespace {

Worker::Options workerOptions() {
  Worker::Options options;
  options.name = "outputs";
  options.is_nice = true;
  return options;
}

}  // namespace

OptionalOutputs::OptionalOutputs(ros::NodeHandle& private_node, Guard guard, Newest newest)
    : guard_(std::move(guard)),
      newest_(std::move(newest)),
      overlaps_(private_node, privateName(kOverlapsTopic), kBoxesQueue,
                greetWith("overlaps", &OptionalOutputs::publishOverlaps, newest_.published)),
      parts_(private_node, privateName(kPartsTopic), kBoxesQueue,
             greetWith("parts", &OptionalOutputs::publishParts, newest_.published)),
      markers_(private_node, privateName(kMarkersTopic), kMarkersQueue,
               greetWith("markers", &OptionalOutputs::publishMarkers, newest_.current)),
      worker_(workerOptions()) {}

/// A key of its own: no newer snapshot takes the place of a greeting.
OutputTopic::OnSubscriber OptionalOutputs::greetWith(const char* topic, Publish publish,
                                                     const std::function<SnapshotPtr()>& newest) {
  return [this, topic, publish, &newest](const SubscriberPtr& subscriber) {
    guard_([&] {
      if (const SnapshotPtr snapshot = newest())
        post(std::string(topic) + std::to_string(++greetings_), publish, snapshot, subscriber);
    });
  };
}

void OptionalOutputs::post(const std::string& key, Publish publish, SnapshotPtr snapshot,
                           SubscriberPtr to) {
  worker_.post(key, [this, publish, snapshot = std::move(snapshot), to = std::move(to)] {
    (this->*publish)(*snapshot, to);
  });
}

void OptionalOutputs::give(const SnapshotPtr& snapshot) {
  if (overlaps_.hasSubscribers()) post("overlaps", &OptionalOutputs::publishOverlaps, snapshot);
  if (parts_.hasSubscribers()) post("parts", &OptionalOutputs::publishParts, snapshot);
}

void OptionalOutputs::giveMarkers(const SnapshotPtr& snapshot) {
  post("markers", &OptionalOutputs::publishMarkers, snapshot);
}

void OptionalOutputs::publishOverlaps(const Snapshot& snapshot, const SubscriberPtr& to) {
  const auto is_over = [this] { return worker_.isStopping(); };
  if (scene_overlaps_.fill(snapshot, overlaps_message_, is_over))
    overlaps_.publish(overlaps_message_, to);
}

void OptionalOutputs::publishParts(const Snapshot& snapshot, const SubscriberPtr& to) {
  if (part_boxes_.fill(snapshot, parts_message_)) parts_.publish(parts_message_, to);
}

/// Of a greeting no other subscriber hears, so it leaves alone what is remembered for all.
void OptionalOutputs::publishMarkers(const Snapshot& snapshot, const SubscriberPtr& to) {
  visualization_msgs::MarkerArray message = boxMarkers(snapshot);
  if (!to) shown_.replaceBy(message, snapshot.header, markers_.takeLoss());
  markers_.publish(message, to);
}

void OptionalOutputs::adopt() {
  worker_.post("adopt", [this] { part_boxes_ = PartBoxes(); });
}

void OptionalOutputs::freeSpareMemory() {
  worker_.post("memory", [this] {
    scene_overlaps_ = SceneOverlaps();
    overlaps_message_ = BoxOverlapArray();
  });
}

}  // namespace link_bounds
