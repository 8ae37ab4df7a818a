// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds pairs of boxes and reports those that the model does not exclude.
#include "node/outputs/overlap_message.h"

namespace link_bounds {
namespace {

constexpr std::size_t kPairsPerLook = 1000;  // some 0.1 ms

}  // namespace

void SceneOverlaps::collect(const Snapshot& snapshot) {
  boxes_.clear();
  owners_.clear();
  for (const SnapshotBody& body : snapshot.bodies) {
    boxes_.push_back(body.box);
    owners_.push_back({&snapshot.name(body), body.link});
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

bool SceneOverlaps::fill(const Snapshot& snapshot, BoxOverlapArray& message,
                         const std::function<bool()>& is_over) {
  const Model& model = *snapshot.model;
  message.header = snapshot.header;
  collect(snapshot);
  std::size_t count = 0;
  for (const BoxPair& pair : search_.find(boxes_, model.parameters.overlap_margin)) {
    const PairMember& first = owners_[pair.first];
    const PairMember& second = owners_[pair.second];
    if (!isPair(model, first, second)) continue;
    if (count % kPairsPerLook == 0 && is_over()) return false;
    BoxOverlap& overlap = nextOf(message.overlaps, count++);
    overlap.first = *first.name;
    overlap.second = *second.name;
    overlap.distance = pair.distance;
  }
  for (; message.overlaps.size() > count; message.overlaps.pop_back())
    spare_.push_back(std::move(message.overlaps.back()));
  return true;
}

}  // namespace link_bounds
