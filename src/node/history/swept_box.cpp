// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/history/swept_box.h"

namespace link_bounds {

SweptBox sweptBox(const TransformBuffer& tf, TransformBuffer::Frame target,
                  TransformBuffer::Frame source, MotionSpan span, const BoundedLink& link,
                  double /*timeout*/) {
  if (span.begin != span.end) return {{}, "the box of a motion cannot be computed yet"};
  const auto pose = tf.pose(target, source, span.begin);
  if (!pose) {
    return {{}, "no transform from \"" + tf.name(source) + "\" to \"" + tf.name(target) + "\""};
  }
  return {linkBox(link, MatrixPose(*pose).affine), ""};
}

}  // namespace link_bounds
