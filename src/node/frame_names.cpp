// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A name is searched for where the guess fails.
#include "frame_names.h"

namespace link_bounds {

FrameNames::Frame FrameNames::frame(std::string_view name) {
  const auto found = frames_.find(name);
  if (found != frames_.end()) return found->second;
  const Frame frame = names_.size();
  frames_.emplace(names_.emplace_back(name), frame);
  followers_.push_back(0);
  return frame;
}

FrameNames::Frame FrameNames::next(std::string_view name) {
  const Frame result = frame(name, followers_[last_]);
  followers_[last_] = result;
  last_ = result + 1;
  return result;
}

}  // namespace link_bounds
