// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The position of each frame on a walk through the frames. A new walk does not clear the marks:
// each mark has the number of its walk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace link_bounds {

class WalkMarks {
 public:
  /// Begins a walk among `frame_count` frames, of which none is marked yet.
  void begin(std::size_t frame_count) {
    ++walk_;
    grow(frame_count);
  }

  /// To be called when frames were added during the walk; they are not marked.
  void grow(std::size_t frame_count) {
    if (marks_.size() < frame_count) marks_.resize(frame_count);
  }

  void set(std::size_t frame, std::size_t position) { marks_[frame] = {walk_, position}; }

  /// Nothing if the frame is not marked.
  std::optional<std::size_t> position(std::size_t frame) const {
    if (marks_[frame].walk != walk_) return std::nullopt;
    return marks_[frame].position;
  }

 private:
  struct Mark {
    std::uint64_t walk = 0;
    std::size_t position = 0;
  };

  std::vector<Mark> marks_;
  std::uint64_t walk_ = 0;
};

}  // namespace link_bounds
