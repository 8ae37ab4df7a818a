// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The candidates that are near indeed.
#include "link_bounds/geometry/overlaps/box_overlaps.h"

#include "geometry/overlaps/overlap_candidates.h"

namespace link_bounds {

struct OverlapSearch::Memory {
  OverlapCandidates candidates;
  std::vector<BoxPair> overlaps;
};

OverlapSearch::OverlapSearch() : memory_(std::make_unique<Memory>()) {}
OverlapSearch::~OverlapSearch() = default;
OverlapSearch::OverlapSearch(OverlapSearch&& other) noexcept = default;
OverlapSearch& OverlapSearch::operator=(OverlapSearch&& other) noexcept = default;

const std::vector<BoxPair>& OverlapSearch::find(const std::vector<Aabb>& boxes, double margin) {
  update(boxes, margin, memory_->candidates);
  memory_->overlaps.clear();
  for (const NumberPair pair : memory_->candidates.pairs) {
    const std::size_t first = firstOf(pair);
    const std::size_t second = secondOf(pair);
    const double distance = signedDistance(boxes[first], boxes[second]);
    if (distance <= margin) memory_->overlaps.push_back({first, second, distance});
  }
  return memory_->overlaps;
}

}  // namespace link_bounds
