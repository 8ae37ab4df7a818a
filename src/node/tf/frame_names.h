// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers for the names of frames. A publisher names the same edges in the same order again and
// again, so most are known before they are read and only have to be compared.
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

  struct Edge {
    Frame child;
    Frame parent;
  };

  /// The number of a name, the same for ever: 0 for the first name, then 1, ...
  Frame frame(std::string_view name);

  /// Before the first next() of a message.
  void beginMessage() { last_ = 0; }

  /// The edge between two names. `key` is empty or a text that no other two names have; this makes
  /// it quick if the edge follows the one before it as it did in an earlier message.
  Edge next(std::string_view parent, std::string_view child, std::string_view key) {
    const Frame guess = followers_[last_];
    if (key.empty() || guess >= keys_.size() || keys_[guess] != key) {
      return find(parent, child, key);
    }
    last_ = guess + 1;
    return {guess, parents_[guess]};
  }

  const std::string& name(Frame frame) const { return names_[frame]; }
  std::size_t size() const { return names_.size(); }

 private:
  Edge find(std::string_view parent, std::string_view child, std::string_view key);

  std::deque<std::string> names_;  ///< does not move them
  std::unordered_map<std::string_view, Frame> frames_;
  std::vector<std::string> keys_;    ///< of the edge that was last seen to a child
  std::vector<Frame> parents_;       ///< in that edge
  std::vector<Frame> followers_{0};  ///< at 0 of the beginning, at 1 + i of child i
  std::size_t last_ = 0;
};

}  // namespace link_bounds
