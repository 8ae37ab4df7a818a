// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers for the names of frames.
//
// A publisher sends the same edges in the same order again and again. So the edge that followed in
// an earlier message is compared first, by the bytes of both names. Without this an update of 50 to
// 200 links takes 1.2 times as long and misses a target of `scripts/bench pipeline`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace link_bounds {

class FrameNames {
 public:
  using Frame = std::size_t;

  FrameNames() = default;
  FrameNames(const FrameNames&) = delete;
  FrameNames& operator=(const FrameNames&) = delete;

  struct Edge {
    Frame child;
    Frame parent;
  };

  /// The number of a name, the same until forget(): 0 for the first name, then 1, ...
  Frame frame(std::string_view name);

  /// The name gets another number when it comes again. name() knows it until reuse().
  void forget(Frame frame);

  /// Another name may get this number, which was forgotten.
  void reuse(Frame frame);

  /// The next search for an edge of the child looks its names up.
  void forgetEdge(Frame child) { keys_[child].clear(); }

  /// The parent that next() may return for the child without looking it up.
  std::optional<Frame> cachedParent(Frame child) const {
    return keys_[child].empty() ? std::nullopt : std::optional(parents_[child]);
  }

  /// Nothing if no frame has this name.
  std::optional<Frame> known(std::string_view name) const;

  /// A new number for a name that lives elsewhere, at least as long as this object. Only name()
  /// knows it.
  Frame borrow(const std::string& name);

  /// Makes room for so many names that are borrowed.
  void reserve(std::size_t count) { names_.reserve(count); }

  /// Before the first next() of a message.
  void beginMessage() { last_ = 0; }

  /// The edge between two names. `key` is empty or a text that no other two names have: it makes
  /// the search fast if the edge follows the previous one as it did in an earlier message.
  Edge next(std::string_view parent, std::string_view child, std::string_view key) {
    const Frame guess = followers_[last_];
    if (key.empty() || guess >= keys_.size() || keys_[guess] != key) {
      return find(parent, child, key);
    }
    last_ = guess + 1;
    return {guess, parents_[guess]};
  }

  const std::string& name(Frame frame) const { return *names_[frame]; }
  std::size_t size() const { return names_.size(); }

 private:
  Edge find(std::string_view parent, std::string_view child, std::string_view key);

  std::vector<std::unique_ptr<const std::string>> own_;  ///< `names_` and `frames_` point there
  std::vector<Frame> reusable_;
  std::vector<const std::string*> names_;
  std::unordered_map<std::string_view, Frame> frames_;
  std::vector<std::string> keys_;    ///< by child: of its last edge
  std::vector<Frame> parents_;       ///< by child: in that edge
  std::vector<Frame> followers_{0};  ///< [0]: the first child of a message; [1 + i]: that after i
  std::size_t last_ = 0;             ///< index in `followers_` for the next edge
};

}  // namespace link_bounds
