// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers for the names of frames.
//
// A publisher sends the same edges in the same order again and again. So next() first compares the
// edge that came next in an earlier message, by the bytes of both names. Without this an update of
// 50 to 200 links takes 1.2 times as long and misses a target of `scripts/bench pipeline`.
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

  /// From now on frame() gives the name another number. name() returns it until reuse().
  void forget(Frame frame);

  /// Another name may get this number. forget() must have been called for it.
  void reuse(Frame frame);

  /// The next search for the edge of this child looks up its names instead of guessing.
  void forgetEdge(Frame child) { keys_[child].clear(); }

  /// The parent that next() may return for the child without looking it up.
  std::optional<Frame> cachedParent(Frame child) const {
    return keys_[child].empty() ? std::nullopt : std::optional(parents_[child]);
  }

  /// The number of the name; nothing if no frame has this name.
  std::optional<Frame> known(std::string_view name) const;

  /// A new number for a name that is stored elsewhere, at least as long as this object lives. Only
  /// name() knows the number; frame() and known() do not find the name.
  Frame borrow(const std::string& name);

  /// Makes room for `count` borrowed names.
  void reserve(std::size_t count) { names_.reserve(count); }

  /// To be called before the first next() of each message.
  void beginMessage() { last_ = 0; }

  /// The edge between two names. `key` is empty or a text that belongs to these two names only.
  /// With a key, the search is fast if the previous edge is the same as in an earlier message.
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

  std::vector<std::unique_ptr<const std::string>> own_;  ///< `names_`, `frames_` point to these
  std::vector<Frame> reusable_;
  std::vector<const std::string*> names_;
  std::unordered_map<std::string_view, Frame> frames_;
  std::vector<std::string> keys_;    ///< by child: the key of its last edge
  std::vector<Frame> parents_;       ///< by child: the parent in its last edge
  std::vector<Frame> followers_{0};  ///< [0]: first child of a message; [1 + i]: child after i
  std::size_t last_ = 0;             ///< index in `followers_` for the next edge
};

}  // namespace link_bounds
