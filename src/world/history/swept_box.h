// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A box that a link does not leave during a recorded motion.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "world/history/motion_path.h"

namespace link_bounds {

/// SweptBox::problem if `gives_up` returned true.
constexpr const char* kNotInTime = "there was no time to compute its box";

/// Max distance of the points of the link's shapes from the origin of its frame [m].
double radiusOf(const BoundedLink& link);

struct SweptBox {
  std::optional<Aabb> box;  ///< in the target frame, padded as linkBox() does it
  std::string problem;      ///< why there is no box, in words; "" if there is one
};

/// A box that contains the link's box in each pose that tf2 gives for the frame `source` in the
/// frame `target` at a time of the span, interpolated or not. Along each axis it is longer than the
/// smallest such box by at most 1 mm + 1 %, unless the motion is so fast that a million poses do
/// not suffice.
///
/// There is no box if tf does not know the whole motion: if a history does not cover the span, if
/// an edge between the frames changes its parent meanwhile, if two successive samples are further
/// apart than `timeout` (seconds; 0: no limit), or if a pose is not finite. There is also none if
/// `gives_up`, which is called often, returns true before the box is proven.
SweptBox sweptBox(
    const TransformBuffer& tf, TransformBuffer::Frame target, TransformBuffer::Frame source,
    MotionSpan span, const BoundedLink& link, double timeout,
    const std::function<bool()>& gives_up = [] { return false; });

}  // namespace link_bounds
