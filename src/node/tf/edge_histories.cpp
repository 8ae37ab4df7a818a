// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Climbs from the source as far as it goes, then from the target until it meets that way.
#include "node/tf/edge_histories.h"

#include <algorithm>

namespace link_bounds {

bool EdgeHistories::insert(Frame child, Frame parent, std::int64_t stamp,
                           const Tf2Pose& parent_from_child, bool is_static) {
  const Frame last = std::max(child, parent);
  if (last >= histories_.size()) histories_.resize(last + 1);
  auto& history = histories_[child];
  if (!history) history.emplace(is_static);
  return history->insert(stamp, parent, parent_from_child);
}

void EdgeHistories::clear() {
  for (auto& history : histories_) {
    if (history) history->clear();
  }
}

void EdgeHistories::clear(Frame child) {
  histories_[child]->clear();
}

/// Ends at the target or where a history ends; false if a loop closes.
bool EdgeHistories::climb(Frame source, Frame target, std::int64_t stamp) const {
  marks_.begin(histories_.size());
  steps_.assign(1, {source, Tf2Pose()});
  marks_.set(source, 0);
  EdgeSample scratch;
  while (steps_.back().frame != target) {
    const EdgeSample* edge = at(steps_.back().frame, stamp, scratch);
    if (!edge) return true;
    if (marks_.position(edge->parent)) return false;
    marks_.set(edge->parent, steps_.size());
    steps_.push_back({edge->parent, edge->parent_from_child * steps_.back().frame_from_source});
  }
  return true;
}

std::optional<Tf2Pose> EdgeHistories::pose(Frame target, Frame source, std::int64_t stamp) const {
  if (source == target) return Tf2Pose();
  if (std::max(source, target) >= histories_.size()) return std::nullopt;
  if (!climb(source, target, stamp)) return std::nullopt;
  Tf2Pose frame_from_target;
  Frame frame = target;
  EdgeSample scratch;
  for (std::size_t steps = 0; !marks_.position(frame); ++steps) {
    const EdgeSample* edge = at(frame, stamp, scratch);
    if (steps > histories_.size() || !edge) return std::nullopt;
    frame_from_target = edge->parent_from_child * frame_from_target;
    frame = edge->parent;
  }
  const Tf2Pose& frame_from_source = steps_[*marks_.position(frame)].frame_from_source;
  if (frame == target) return frame_from_source;
  return inverse(frame_from_target) * frame_from_source;
}

}  // namespace link_bounds
