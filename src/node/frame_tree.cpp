// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A flat table of edges.
#include "frame_tree.h"

#include <algorithm>

namespace link_bounds {

FrameTree::Frame FrameTree::frame(const std::string& name) {
  const auto found = frames_.find(name);
  if (found != frames_.end()) return found->second;
  edges_.emplace_back();
  return frames_.emplace(name, edges_.size() - 1).first->second;
}

void FrameTree::heard(Frame child, Frame parent, bool is_static, std::int64_t stamp,
                      std::int64_t now) {
  Edge& edge = edges_[child];
  if (!edge.is_known) edge.is_static = is_static;
  edge.is_known = true;
  edge.heard = now;
  edge.message = message_;
  if (edge.exists && !edge.is_static && stamp < edge.newest) return;
  edge.newest = stamp;
  if (!edge.exists || edge.parent != parent) ++structure_;
  edge.exists = true;
  edge.parent = parent;
}

void FrameTree::forgetDynamic() {
  for (Edge& edge : edges_) {
    if (!edge.is_static) edge.exists = false;
  }
  ++structure_;
}

void FrameTree::clockStarted(std::int64_t now) {
  for (Edge& edge : edges_) {
    if (edge.heard == 0) edge.heard = now;
  }
}

/// `from` and everything above it; cut off where a loop would close.
std::vector<FrameTree::Frame> FrameTree::ancestors(Frame from) const {
  std::vector<Frame> chain{from};
  while (edges_[chain.back()].exists && chain.size() <= edges_.size()) {
    chain.push_back(edges_[chain.back()].parent);
  }
  return chain;
}

std::optional<std::vector<FrameTree::Frame>> FrameTree::path(Frame from, Frame to) const {
  std::vector<Frame> up = ancestors(from);
  std::vector<Frame> down = ancestors(to);
  if (up.back() != down.back()) return std::nullopt;
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  up.insert(up.end(), down.begin(), down.end());
  return up;
}

}  // namespace link_bounds
