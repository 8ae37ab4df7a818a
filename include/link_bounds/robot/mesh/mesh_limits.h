// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Limits of loading one mesh.
#pragma once

#include <cstdint>
#include <functional>

#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

struct MeshLimits {
  double timeout = 30.0;                ///< wall seconds per file, > 0; preparing it included
  std::uint64_t max_bytes = 536870912;  ///< max size of a file; its mesh may take 16 MiB more
};

/// Throws MeshError when `limits.timeout` has passed since this call, or when `is_cancelled`, which
/// may be null, returns true.
CheckInterrupt meshDeadline(const MeshLimits& limits, std::function<bool()> is_cancelled);

/// Throws the MeshError for a mesh that takes longer than `limits.timeout`.
[[noreturn]] void throwTooSlow(const MeshLimits& limits);

}  // namespace link_bounds
