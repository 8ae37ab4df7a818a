// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Only objects of further topics are stored; all others belong to the first one. So one topic costs
// nothing.
#include "tools/bag_bounds/scene/object_topics.h"

#include <algorithm>
#include <utility>

#include "world/bodies/marker_shape.h"
#include "world/bodies/neighbour_boxes.h"
#include "world/bodies/object_source.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

constexpr std::size_t kMinForgotten = 1000;

ObjectKey keyOf(const Marker& marker) {
  return {marker.ns, marker.id};
}

}  // namespace

void ObjectTopics::noteUse(const Markers& markers, const std::string& topic) {
  if (used_.count(topic) > 0) return;
  if (!markers.empty() && std::all_of(markers.begin(), markers.end(), isDrawing)) {
    ignored_.insert(topic);
  } else {
    used_.insert(topic);
    ignored_.erase(topic);
  }
}

const std::string& ObjectTopics::topicOf(const ObjectKey& key) const {
  const auto found = further_.find(key);
  return found == further_.end() ? first_ : found->second;
}

void ObjectTopics::keepOwn(Markers& markers, const std::string& topic,
                           const std::string& publisher) {
  noteUse(markers, topic);
  if (first_.empty()) first_ = topic;
  if (topic == first_ && further_.empty()) return;
  Markers own;
  for (Marker& marker : markers) {
    if (marker.action == Marker::DELETEALL) {
      addDeletions(topic, isDrawing(marker) ? &publisher : nullptr, own);
    } else if (!isDrawing(marker)) {
      keepOwn(marker, topic, own);
    }
  }
  markers = std::move(own);
  forgetDeleted();
}

void ObjectTopics::keepOwn(Marker& marker, const std::string& topic, Markers& own) {
  const ObjectKey key = keyOf(marker);
  const std::string& owner = topicOf(key);
  if (owner != topic && objects_.objects().count(key) > 0) {
    if (marker.action == Marker::ADD && hasShape(marker)) leaveOut(objectName(key), topic, owner);
    return;
  }
  if (topic == first_) {
    further_.erase(key);
  } else {
    further_[key] = topic;
  }
  own.push_back(std::move(marker));
}

/// Replaces a DELETEALL: adds a DELETE for each object of the topic that is in the scene or earlier
/// in the message. With `publisher`, only objects in the scene from that publisher.
void ObjectTopics::addDeletions(const std::string& topic, const std::string* publisher,
                                Markers& own) const {
  std::set<ObjectKey> keys;
  for (const Marker& marker : own)
    keys.insert(keyOf(marker));
  for (const auto& [key, object] : objects_.objects()) {
    const bool is_sender = !publisher || object.sender == *publisher;
    if (!object.content->is_neighbour && is_sender && topicOf(key) == topic) keys.insert(key);
  }
  for (const ObjectKey& key : keys) {
    Marker& marker = own.emplace_back();
    marker.ns = key.ns;
    marker.id = key.id;
    marker.action = Marker::DELETE;
  }
}

/// Limits memory: a publisher may send ever new names.
void ObjectTopics::forgetDeleted() {
  if (further_.size() < kMinForgotten + 2 * objects_.objects().size()) return;
  for (auto entry = further_.begin(); entry != further_.end();)
    entry = objects_.objects().count(entry->first) ? std::next(entry) : further_.erase(entry);
}

/// Tells the boxes of a sender apart by frame and links, as NeighbourSets does. An empty message
/// has neither, so it is accepted only if all boxes of the sender come from this topic.
bool ObjectTopics::isOwn(const AxisAlignedBoxArray& boxes, const std::string& topic,
                         const std::string& publisher) {
  used_.insert(topic);
  ignored_.erase(topic);
  const NeighbourBoxes neighbour = neighbourBoxes(boxes, publisher);
  Sender& sender = senders_[publisher];
  if (neighbour.contents.empty()) {
    const auto is_other = [&topic](const auto& entry) { return entry.second != topic; };
    return std::none_of(sender.topics.begin(), sender.topics.end(), is_other);
  }
  std::set<std::string> links = linksOf(neighbour);
  if (links.empty()) links.insert("");
  for (const std::string& link : links) {
    const std::string& owner =
        sender.topics.try_emplace(neighbour.frame + '\n' + link, topic).first->second;
    if (owner == topic) continue;
    leaveOut(neighbourName(publisher, link), topic, owner);
    return false;
  }
  return true;
}

void ObjectTopics::leaveOut(const std::string& name, const std::string& topic,
                            const std::string& by) {
  if (left_out_++ == 0)
    first_left_out_ = "\"" + name + "\" on " + topic + ": an object of " + by + " has that name";
}

std::string ObjectTopics::loss() const {
  if (left_out_ == 0) return "";
  return std::to_string(left_out_) + (left_out_ == 1 ? " object was" : " objects were") +
         " left out, the first one " + first_left_out_ + "; give one --objects at a time";
}

}  // namespace link_bounds
