// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds pairs of boxes and reports those that the model does not exclude.
#include "node/outputs/overlap_message.h"

#include "link_bounds/ros/messages.h"

namespace link_bounds {

void SceneOverlaps::collect(const AxisAlignedBoxArray& boxes,
                            const std::vector<std::size_t>& links) {
  boxes_.clear();
  owners_.clear();
  for (const AxisAlignedBox& box : boxes.boxes) {
    const std::size_t i = boxes_.size();
    boxes_.push_back(toAabb(box));
    owners_.push_back({&box.name, i < links.size() ? std::optional(links[i]) : std::nullopt});
  }
}

/// Entry `count` of the list; at its end, appends a spare entry or a new one.
BoxOverlap& SceneOverlaps::nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count) {
  if (count < overlaps.size()) return overlaps[count];
  if (spare_.empty()) return overlaps.emplace_back();
  overlaps.push_back(std::move(spare_.back()));
  spare_.pop_back();
  return overlaps.back();
}

void SceneOverlaps::fill(const Model& model, const AxisAlignedBoxArray& boxes,
                         const std::vector<std::size_t>& links, BoxOverlapArray& message) {
  message.header = boxes.header;
  collect(boxes, links);
  std::size_t count = 0;
  for (const BoxPair& pair : search_.find(boxes_, model.parameters.overlap_margin)) {
    const PairMember& first = owners_[pair.first];
    const PairMember& second = owners_[pair.second];
    if (!isPair(model, first, second)) continue;
    BoxOverlap& overlap = nextOf(message.overlaps, count++);
    overlap.first = *first.name;
    overlap.second = *second.name;
    overlap.distance = pair.distance;
  }
  for (; message.overlaps.size() > count; message.overlaps.pop_back())
    spare_.push_back(std::move(message.overlaps.back()));
}

}  // namespace link_bounds
