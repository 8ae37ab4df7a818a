// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Transforms that can never be used, by the rules of tf2's setTransform.
#pragma once

#include "world/tf/tf_message.h"

namespace link_bounds {

/// Why the transform is refused, with the remedy; null if it is not. Does not check whether a frame
/// is its own parent.
const char* whyRefused(const TransformView& transform);

}  // namespace link_bounds
