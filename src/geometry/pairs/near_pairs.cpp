// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches near boxes first, so that the rule is asked about few pairs.
#include "geometry/pairs/near_pairs.h"

namespace link_bounds {
namespace {

constexpr std::size_t kPairsPerLook = 1000;  // some 0.1 ms

/// Lists a pair that is left out. If the list is full, marks both bodies as not listed, so that the
/// pair does not look as if it were compared.
void leaveOut(const BoxPair& pair, const NearPairsGoal& goal, NearPairs& result) {
  if (pair.distance > goal.left_out_margin) return;
  if (result.left_out.size() < goal.max_left_out) {
    result.left_out.push_back(pair);
  } else {
    result.is_listed[pair.first] = false;
    result.is_listed[pair.second] = false;
  }
}

}  // namespace

bool NearPairSearch::find(const std::vector<Aabb>& boxes, const NearPairsGoal& goal,
                          const Rule& rule, NearPairs& result,
                          const std::function<bool()>& is_over) {
  result.compared.clear();
  result.left_out.clear();
  result.is_listed.assign(boxes.size(), true);
  std::size_t count = 0;
  for (const BoxPair& pair : search_.find(boxes, goal.margin)) {
    if (count++ % kPairsPerLook == 0 && is_over()) return false;
    if (rule(pair.first, pair.second)) {
      result.compared.push_back(pair);
    } else {
      leaveOut(pair, goal, result);
    }
  }
  return true;
}

}  // namespace link_bounds
