// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers for the names of frames. A publisher names the same frames in the same order again and
// again, so most names are known before they are read and only have to be compared.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace link_bounds {

class FrameNames {
 public:
  using Frame = std::size_t;

  /// The number of a name, the same for ever: 0 for the first name, then 1, ...
  Frame frame(std::string_view name);

  /// The same; quick if the guess, which may be any number, is right.
  Frame frame(std::string_view name, Frame guess) {
    return guess < names_.size() && names_[guess] == name ? guess : frame(name);
  }

  /// Before the first next() of a message.
  void beginMessage() { last_ = 0; }

  /// The same; quick if the name follows the one before it as it did in an earlier message.
  Frame next(std::string_view name);

  std::size_t size() const { return names_.size(); }

 private:
  std::deque<std::string> names_;  ///< does not move them
  std::unordered_map<std::string_view, Frame> frames_;
  std::vector<Frame> followers_{0};  ///< at 0 of the beginning, at 1 + i of frame i
  std::size_t last_ = 0;
};

}  // namespace link_bounds
