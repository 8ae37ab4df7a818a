// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Overwrites existing entries, so that their strings keep their memory.
#include "node/outputs/messages/box_message.h"

#include <algorithm>
#include <vector>

#include "link_bounds/ros/messages.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

/// Resizes the list. Keeps spare memory for some entries, but not for ten thousand removed objects.
template <class T>
void shorten(std::vector<T>& entries, std::size_t size) {
  constexpr std::size_t kSpare = 1000;  // about 100 KB; large robots have as many entries
  entries.resize(size);
  if (entries.capacity() > 2 * (size + kSpare)) entries.shrink_to_fit();
}

}  // namespace

BoxFiller::BoxFiller(AxisAlignedBoxArray& message, const std::string& frame) : message_(message) {
  message_.header.frame_id = frame;
}

void BoxFiller::add(const std::string& name, const BoxState& state) {
  if (state.incomplete) addIncomplete(name);
  if (!state.box) return;
  if (boxes_ == message_.boxes.size()) message_.boxes.emplace_back();
  AxisAlignedBox& box = message_.boxes[boxes_++];
  if (box.name != name) box.name = name;  // nearly always equal
  box.stamp = timeOf(state.stamp);
  box.min = toPoint(state.box->min());
  box.max = toPoint(state.box->max());
  newest_ = std::max(newest_, state.stamp);
}

void BoxFiller::finish() {
  shorten(message_.boxes, boxes_);
  shorten(message_.incomplete, incomplete_);
  message_.header.stamp = timeFrom(newest_);
}

/// Converts a stamp once for all boxes that have it.
ros::Time BoxFiller::timeOf(std::int64_t stamp) {
  if (stamp != stamp_) time_ = timeFrom(stamp);
  stamp_ = stamp;
  return time_;
}

/// Skips repeated names: objects with the same name come one after the other.
void BoxFiller::addIncomplete(const std::string& name) {
  if (incomplete_ > 0 && message_.incomplete[incomplete_ - 1] == name) return;
  if (incomplete_ == message_.incomplete.size()) message_.incomplete.emplace_back();
  message_.incomplete[incomplete_++] = name;
}

void fillBoxes(const Scene& scene, AxisAlignedBoxArray& message) {
  BoxFiller filler(message, scene.model()->fixed_frame);
  scene.forEach([&](const SceneBody& body) { filler.add(body.name, body.state); });
  filler.finish();
}

void fillBoxes(const Moment& moment, AxisAlignedBoxArray& message) {
  BoxFiller filler(message, moment.header.frame_id);
  for (const Moment::Body& body : moment.bodies)
    filler.add(moment.name(body), {body.box, body.stamp, false});
  for (const std::string& name : moment.incomplete)
    filler.addIncomplete(name);
  filler.finish();
  message.header.stamp = moment.header.stamp;
}

void fillGroups(const Scene& scene, AxisAlignedBoxArray& message) {
  const Model& model = *scene.model();
  BoxFiller filler(message, model.fixed_frame);
  for (const SceneGroup& group : model.groups)
    filler.add(group.name, groupState(group, scene));
  filler.finish();
}

}  // namespace link_bounds
