// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each moment overwrites the same lists, so that after some moments nothing is allocated.
#include "world/moment/moment_pairs.h"

#include <algorithm>

namespace link_bounds {

bool MomentPairs::prepare(const MomentPtr& moment, double margin,
                          const std::function<bool()>& is_over) {
  if (margin <= margin_ && moment_.lock() == moment) return true;
  moment_.reset();
  boxes_.clear();
  for (const Moment::Body& body : moment->bodies)
    boxes_.push_back(body.box);
  const Model& model = *moment->model;
  const double limit = model.parameters.distance_limit;
  margin_ = std::max(margin, expected_.load());
  const NearPairsGoal goal{margin_, limit, static_cast<std::size_t>(model.parameters.max_pairs)};
  const auto rule = [&](std::size_t a, std::size_t b) {
    return isPair(model, moment->member(a), moment->member(b));
  };
  if (!search_.find(boxes_, goal, rule, pairs_, is_over)) return false;
  moment_ = moment;
  return true;
}

void MomentPairs::freeMemory() {
  const std::lock_guard<std::mutex> lock(mutex_);
  search_ = NearPairSearch();
  boxes_ = std::vector<Aabb>();
  pairs_ = NearPairs();
  moment_.reset();
}

}  // namespace link_bounds
