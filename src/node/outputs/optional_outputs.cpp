// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// At most one piece of work per topic waits: that of the newest moment.
#include "node/outputs/optional_outputs.h"

#include <utility>

#include "node/interface/topics.h"

namespace link_bounds {

OptionalOutputs::OptionalOutputs(ros::NodeHandle& private_node, Guard guard, MomentPairs& pairs,
                                 Newest newest)
    : guard_(std::move(guard)),
      pairs_(pairs),
      newest_(std::move(newest)),
      overlaps_(private_node, privateName(kOverlapsTopic), kBoxesQueue,
                greetWith(&OptionalOutputs::publishOverlaps, newest_.published)),
      parts_(private_node, privateName(kPartsTopic), kBoxesQueue,
             greetWith(&OptionalOutputs::publishParts, newest_.published)),
      markers_(private_node, privateName(kMarkersTopic), kMarkersQueue,
               greetWith(&OptionalOutputs::publishMarkers, newest_.current)),
      worker_({"outputs", true}) {}

/// A greeting has no key, so that no newer moment replaces it.
OutputTopic::OnSubscriber OptionalOutputs::greetWith(Publish publish,
                                                     const std::function<MomentPtr()>& newest) {
  return [this, publish, &newest](const SubscriberPtr& subscriber) {
    guard_([&] {
      if (const MomentPtr moment = newest()) post("", publish, moment, subscriber);
    });
  };
}

void OptionalOutputs::post(const std::string& key, Publish publish, MomentPtr moment,
                           SubscriberPtr to) {
  worker_.post(key, [this, publish, moment = std::move(moment), to = std::move(to)] {
    (this->*publish)(moment, to);
  });
}

void OptionalOutputs::give(const MomentPtr& moment) {
  if (overlaps_.hasSubscribers()) post("overlaps", &OptionalOutputs::publishOverlaps, moment);
  if (parts_.hasSubscribers()) post("parts", &OptionalOutputs::publishParts, moment);
}

void OptionalOutputs::giveMarkers(const MomentPtr& moment) {
  post("markers", &OptionalOutputs::publishMarkers, moment);
}

void OptionalOutputs::publishOverlaps(const MomentPtr& moment, const SubscriberPtr& to) {
  const auto is_over = [this] { return worker_.isStopping(); };
  if (overlap_filler_.fill(moment, pairs_, overlaps_message_, is_over))
    overlaps_.publish(overlaps_message_, to);
}

void OptionalOutputs::publishParts(const MomentPtr& moment, const SubscriberPtr& to) {
  if (part_boxes_.fill(*moment, parts_message_)) {
    parts_.publish(parts_message_, to);
    has_shown_parts_ = true;
  } else if (has_shown_parts_ && !to) {
    publishEndOfParts(moment->header);
  }
}

/// Without this message, a listener would take the last parts for current ones.
void OptionalOutputs::publishEndOfParts(const std_msgs::Header& header) {
  parts_message_ = AxisAlignedBoxArray();
  parts_message_.header = header;
  parts_.publish(parts_message_);
  has_shown_parts_ = false;
}

/// Other subscribers do not get a greeting, so it deletes no markers; its own markers are deleted
/// later.
void OptionalOutputs::publishMarkers(const MomentPtr& moment, const SubscriberPtr& to) {
  visualization_msgs::MarkerArray message = boxMarkers(*moment);
  if (to) {
    shown_.add(message);
  } else {
    shown_.replaceBy(message, moment->header, markers_.takeLoss());
  }
  markers_.publish(message, to);
}

/// A listener that connects before the thread does this work must not count.
void OptionalOutputs::adopt() {
  worker_.post("adopt", [this, are_parts_heard = parts_.hasSubscribers()] {
    part_boxes_ = PartBoxes();
    if (!are_parts_heard) has_shown_parts_ = false;
  });
}

void OptionalOutputs::freeSpareMemory() {
  worker_.post("memory", [this] {
    pairs_.freeMemory();
    overlap_filler_ = OverlapFiller();
    overlaps_message_ = BoxOverlapArray();
  });
}

}  // namespace link_bounds
