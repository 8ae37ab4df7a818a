// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks names up where the guess is wrong.
#include "node/tf/frame_names.h"

namespace link_bounds {

FrameNames::Frame FrameNames::frame(std::string_view name) {
  const auto found = frames_.find(name);
  if (found != frames_.end()) return found->second;
  const Frame frame = borrow(own_.emplace_back(name));
  frames_.emplace(own_.back(), frame);
  keys_.resize(frame + 1);
  parents_.resize(frame + 1);
  followers_.resize(frame + 2);
  return frame;
}

FrameNames::Frame FrameNames::borrow(const std::string& name) {
  names_.push_back(&name);
  return names_.size() - 1;
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
