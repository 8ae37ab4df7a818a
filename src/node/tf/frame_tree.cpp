// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A flat table of edges.
#include "node/tf/frame_tree.h"

#include <limits>

namespace link_bounds {
namespace {

constexpr std::size_t kAboveTarget = std::numeric_limits<std::size_t>::max();

}  // namespace

void FrameTree::heard(Frame child, Frame parent, bool is_static, std::int64_t stamp,
                      std::int64_t now) {
  Edge& edge = edges_[child];
  if (!edge.is_known) edge.is_static = is_static;
  edge.is_known = true;
  edge.heard = now;
  edge.message = message_;
  edge.is_distrusted = false;
  const bool is_late = edge.exists && !edge.is_static && stamp < edge.newest;
  if (!edge.exists || edge.parent != parent) ++structure_;
  if (edge.exists && edge.parent != parent) settled_ = std::max({settled_, stamp, edge.newest});
  if (is_late) return;
  edge.newest = edge.is_static ? 0 : stamp;
  edge.exists = true;
  edge.parent = parent;
}

void FrameTree::forgetDynamic() {
  for (Frame edge = 0; edge < edges_.size(); ++edge) {
    if (!edges_[edge].is_static) forget(edge);
  }
}

void FrameTree::forget(Frame edge) {
  edges_[edge].exists = false;
  edges_[edge].newest = 0;
  ++structure_;
}

void FrameTree::distrustStampsAfter(std::int64_t stamp) {
  for (Edge& edge : edges_)
    edge.is_distrusted = edge.newest > stamp;
}

void FrameTree::clockStarted(std::int64_t now) {
  for (Edge& edge : edges_) {
    if (edge.heard == 0) edge.heard = now;
  }
}

/// Climbs from `from` to `to` or to the top, then from `to` until it meets that way.
std::optional<std::vector<FrameTree::Frame>> FrameTree::path(Frame from, Frame to) const {
  marks_.begin(edges_.size());
  std::vector<Frame> up;
  Frame top = from;
  marks_.set(top, 0);
  while (top != to && hasParent(top)) {
    up.push_back(top);
    top = parent(top);
    if (marks_.position(top)) return std::nullopt;
    marks_.set(top, up.size());
  }
  std::vector<Frame> down;
  Frame below = to;
  while (!marks_.position(below)) {
    if (!hasParent(below)) return std::nullopt;
    marks_.set(below, kAboveTarget);
    down.push_back(below);
    below = parent(below);
  }
  const std::size_t meeting = *marks_.position(below);
  if (meeting == kAboveTarget) return std::nullopt;
  up.resize(meeting);
  up.insert(up.end(), down.begin(), down.end());
  return up;
}

}  // namespace link_bounds
