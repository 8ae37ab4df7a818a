// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes are those of ~boxes, in the same order.
#include "node/outputs/overlap_message.h"

#include "link_bounds/ros/messages.h"

namespace link_bounds {

void SceneOverlaps::collect(const Model& model, const AxisAlignedBoxArray& boxes,
                            std::size_t link_count) {
  boxes_.clear();
  owners_.clear();
  std::size_t link = 0;
  for (const AxisAlignedBox& box : boxes.boxes) {
    boxes_.push_back(toAabb(box));
    Owner& owner = owners_.emplace_back(Owner{&box.name, std::nullopt});
    if (owners_.size() > link_count) continue;
    while (model.links[link].name != box.name)
      ++link;
    owner.link = link++;
  }
}

bool SceneOverlaps::isReported(const Model& model, const Owner& a, const Owner& b) const {
  if (a.link && b.link && areJoined(model.bodies, *a.link, *b.link)) return false;
  return !model.ignored_pairs.contains(*a.name, *b.name);
}

/// Entry `count`, the last one or a new one.
BoxOverlap& SceneOverlaps::nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count) {
  if (count < overlaps.size()) return overlaps[count];
  if (spare_.empty()) return overlaps.emplace_back();
  overlaps.push_back(std::move(spare_.back()));
  spare_.pop_back();
  return overlaps.back();
}

void SceneOverlaps::fill(const Model& model, const AxisAlignedBoxArray& boxes,
                         std::size_t link_count, BoxOverlapArray& message) {
  message.header = boxes.header;
  collect(model, boxes, link_count);
  std::size_t count = 0;
  for (const BoxPair& pair : search_.find(boxes_, model.parameters.overlap_margin)) {
    const Owner& first = owners_[pair.first];
    const Owner& second = owners_[pair.second];
    if (!isReported(model, first, second)) continue;
    BoxOverlap& overlap = nextOf(message.overlaps, count++);
    overlap.first = *first.name;
    overlap.second = *second.name;
    overlap.distance = pair.distance;
  }
  for (; message.overlaps.size() > count; message.overlaps.pop_back())
    spare_.push_back(std::move(message.overlaps.back()));
}

}  // namespace link_bounds
