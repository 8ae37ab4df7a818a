// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The way from a frame upwards, by the newest parents. In a loop it ends after as many steps as
// there are frames.
#pragma once

#include <vector>

#include "world/tf/transform_buffer.h"

namespace link_bounds {

/// The first frame from `frame` upwards for which `ends` returns true; if there is none, the last
/// frame.
template <class Ends>
TransformBuffer::Frame climb(const TransformBuffer& tf, TransformBuffer::Frame frame, Ends ends) {
  for (std::size_t i = 0; i < tf.size() && !ends(frame) && tf.hasParent(frame); ++i)
    frame = tf.parent(frame);
  return frame;
}

/// The frame and all its ancestors.
inline std::vector<TransformBuffer::Frame> wayUp(const TransformBuffer& tf,
                                                 TransformBuffer::Frame frame) {
  std::vector<TransformBuffer::Frame> way;
  climb(tf, frame, [&](TransformBuffer::Frame at) {
    way.push_back(at);
    return false;
  });
  return way;
}

/// The child frames of the edges between the two frames; all edges of both ways up if these do not
/// meet.
inline std::vector<TransformBuffer::Frame> edgesBetween(const TransformBuffer& tf,
                                                        TransformBuffer::Frame target,
                                                        TransformBuffer::Frame source) {
  std::vector<TransformBuffer::Frame> first = wayUp(tf, target);
  std::vector<TransformBuffer::Frame> second = wayUp(tf, source);
  while (!first.empty() && !second.empty() && first.back() == second.back()) {
    first.pop_back();
    second.pop_back();
  }
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace link_bounds
