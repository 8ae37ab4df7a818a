// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From states to AxisAlignedBoxArray.
#include "box_message.h"

#include <algorithm>

#include "geometry_message.h"

namespace link_bounds {
namespace {

ros::Time toTime(std::int64_t nanoseconds) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(nanoseconds));
}

/// Keeps memory for what may come back soon, not for ten thousand objects that are gone.
template <class T>
void shorten(std::vector<T>& entries, std::size_t size) {
  constexpr std::size_t kSpare = 1000;
  entries.resize(size);
  if (entries.capacity() > 2 * (size + kSpare)) entries.shrink_to_fit();
}

/// Adds entries to a message whose arrays keep their memory from one filling to the next.
class Filler {
 public:
  Filler(AxisAlignedBoxArray& message, const std::string& frame) : message_(message) {
    message_.header.frame_id = frame;
  }

  void add(const std::string& name, const BoxState& state) {
    if (state.incomplete) incomplete_ = addName(incomplete_, name);
    if (!state.box) return;
    if (boxes_ == message_.boxes.size()) message_.boxes.emplace_back();
    AxisAlignedBox& box = message_.boxes[boxes_++];
    box.name = name;
    box.stamp = toTime(state.stamp);
    box.min = toPoint(state.box->min());
    box.max = toPoint(state.box->max());
    newest_ = std::max(newest_, state.stamp);
  }

  void finish() {
    shorten(message_.boxes, boxes_);
    shorten(message_.incomplete, incomplete_);
    message_.header.stamp = toTime(newest_);
  }

 private:
  std::size_t addName(std::size_t count, const std::string& name) {
    if (count == message_.incomplete.size()) message_.incomplete.emplace_back();
    message_.incomplete[count] = name;
    return count + 1;
  }

  AxisAlignedBoxArray& message_;
  std::size_t boxes_ = 0;
  std::size_t incomplete_ = 0;
  std::int64_t newest_ = 0;
};

}  // namespace

void fillBoxes(const Scene& scene, AxisAlignedBoxArray& message) {
  Filler filler(message, scene.model()->fixed_frame);
  scene.forEach([&](const std::string& name, const BoxState& state) { filler.add(name, state); });
  filler.finish();
}

void fillGroups(const Scene& scene, AxisAlignedBoxArray& message) {
  const Model& model = *scene.model();
  Filler filler(message, model.fixed_frame);
  for (const SceneGroup& group : model.groups)
    filler.add(group.name, groupState(group, scene));
  filler.finish();
}

}  // namespace link_bounds
