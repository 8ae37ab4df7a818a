// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/outputs/messages/overlap_message.h"

#include <utility>

namespace link_bounds {

/// Entry `count` of the list. If the list is shorter, appends a spare entry or a new one.
BoxOverlap& OverlapFiller::nextOf(std::vector<BoxOverlap>& overlaps, std::size_t count) {
  if (count < overlaps.size()) return overlaps[count];
  if (spare_.empty()) return overlaps.emplace_back();
  overlaps.push_back(std::move(spare_.back()));
  spare_.pop_back();
  return overlaps.back();
}

bool OverlapFiller::fill(const MomentPtr& moment, MomentPairs& pairs, BoxOverlapArray& message,
                         const std::function<bool()>& is_over) {
  const double margin = moment->model->parameters.overlap_margin;
  message.header = moment->header;
  std::size_t count = 0;
  const auto read = [&](const NearPairs& near) {
    for (const BoxPair& pair : near.compared) {
      if (pair.distance > margin) continue;
      BoxOverlap& overlap = nextOf(message.overlaps, count++);
      overlap.first = moment->name(moment->bodies[pair.first]);
      overlap.second = moment->name(moment->bodies[pair.second]);
      overlap.distance = pair.distance;
    }
  };
  if (!pairs.read(moment, margin, read, is_over)) return false;
  for (; message.overlaps.size() > count; message.overlaps.pop_back())
    spare_.push_back(std::move(message.overlaps.back()));
  return true;
}

}  // namespace link_bounds
