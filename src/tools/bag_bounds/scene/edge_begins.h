// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Since when tf could tell where a frame is: what it has forgotten since then, nobody looked at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "world/tf/frame_paths.h"

namespace link_bounds {

/// When the moving edges of tf began, in record time [ns].
class EdgeBegins {
 public:
  using Frame = TransformBuffer::Frame;

  /// To be called now and then until the frame is connected: notes the edges above it.
  void look(const TransformBuffer& tf, Frame frame, std::int64_t now) {
    for (const Frame edge : wayUp(tf, frame)) {
      if (tf.hasParent(edge) && !tf.isStatic(edge)) begins_.try_emplace(edge, now);
    }
  }

  /// Of two frames that are connected: since when all moving edges between them are there. Nothing
  /// if none moves.
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

  /// After a jump of the clock: what is not static begins again.
  void clear() { begins_.clear(); }

 private:
  std::map<Frame, std::int64_t> begins_;  ///< by child
};

}  // namespace link_bounds
