// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks names up where the guess is wrong.
#include "node/tf/frame_names.h"

namespace link_bounds {

FrameNames::Frame FrameNames::frame(std::string_view name) {
  const auto found = frames_.find(name);
  if (found != frames_.end()) return found->second;
  const Frame frame = names_.size();
  frames_.emplace(names_.emplace_back(name), frame);
  keys_.emplace_back();
  parents_.push_back(0);
  followers_.push_back(0);
  return frame;
}

void FrameNames::reserve(std::size_t count) {
  frames_.reserve(count);
  keys_.reserve(count);
  parents_.reserve(count);
  followers_.reserve(count + 1);
}

std::optional<FrameNames::Frame> FrameNames::known(std::string_view name) const {
  const auto found = frames_.find(name);
  if (found == frames_.end()) return std::nullopt;
  return found->second;
}

FrameNames::Edge FrameNames::find(std::string_view parent, std::string_view child,
                                  std::string_view key) {
  const Edge edge{frame(child), frame(parent)};
  keys_[edge.child] = key;
  parents_[edge.child] = edge.parent;
  followers_[last_] = edge.child;
  last_ = edge.child + 1;
  return edge;
}

}  // namespace link_bounds
