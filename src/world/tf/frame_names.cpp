// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks up the names of an edge if the guess of next() is wrong.
#include "world/tf/frame_names.h"

#include <utility>

namespace link_bounds {

FrameNames::Frame FrameNames::frame(std::string_view name) {
  const auto found = frames_.find(name);
  if (found != frames_.end()) return found->second;
  auto own = std::make_unique<const std::string>(name);
  Frame frame = names_.size();
  if (reusable_.empty()) {
    names_.push_back(own.get());
    own_.resize(frame + 1);  // borrow() adds to `names_` only
    keys_.resize(frame + 1);
    parents_.resize(frame + 1);
    followers_.resize(frame + 2);
  } else {
    frame = reusable_.back();
    reusable_.pop_back();
    names_[frame] = own.get();
  }
  frames_.emplace(*own, frame);
  own_[frame] = std::move(own);
  return frame;
}

void FrameNames::forget(Frame frame) {
  frames_.erase(*names_[frame]);
  forgetEdge(frame);
}

void FrameNames::reuse(Frame frame) {
  own_[frame] = nullptr;
  reusable_.push_back(frame);
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
