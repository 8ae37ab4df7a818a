// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Record times since when tf knows where a frame is. Motions that tf forgot since then were never
// examined.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "world/tf/frame_paths.h"

namespace link_bounds {

/// Record times [ns] at which the moving edges of tf began.
class EdgeBegins {
 public:
  using Frame = TransformBuffer::Frame;

  /// Notes the moving edges above `frame`. Call it regularly until the frame is connected.
  void look(const TransformBuffer& tf, Frame frame, std::int64_t now) {
    for (const Frame edge : wayUp(tf, frame)) {
      if (tf.hasParent(edge) && !tf.isStatic(edge)) begins_.try_emplace(edge, now);
    }
  }

  /// The time since when all moving edges between two connected frames exist; std::nullopt if all
  /// edges are static.
  std::optional<std::int64_t> allSince(const TransformBuffer& tf, Frame target, Frame source,
                                       std::int64_t now) const {
    std::optional<std::int64_t> since;
    for (const Frame edge : edgesBetween(tf, target, source)) {
      if (tf.isStatic(edge)) continue;
      const auto begin = begins_.find(edge);
      since = std::max(since.value_or(0), begin == begins_.end() ? now : begin->second);
    }
    return since;
  }

  /// Call it after a jump of the clock: all moving edges begin again.
  void clear() { begins_.clear(); }

 private:
  std::map<Frame, std::int64_t> begins_;  ///< by child frame
};

}  // namespace link_bounds
