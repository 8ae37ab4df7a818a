// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Explains why tf has no pose at some time.
#pragma once

#include <string>

#include "world/tf/tf_excerpt.h"

namespace link_bounds {

/// Why there is no pose of `source` in `target` at `stamp` [ns], in words. Call this only if there
/// is none.
std::string whyNoPose(const TfExcerpt& excerpt, TransformBuffer::Frame target,
                      TransformBuffer::Frame source, std::int64_t stamp);

/// True if static transforms alone lead from one frame to the other.
bool isStaticPath(const TransformBuffer& tf, TransformBuffer::Frame target,
                  TransformBuffer::Frame source);

/// A time as users write it: seconds with up to nine decimals.
std::string secondsText(std::int64_t nanoseconds);

}  // namespace link_bounds
