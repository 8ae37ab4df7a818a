// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes that the links of a measured robot share.
#pragma once

#include "bench/common/measured_mesh.h"

namespace link_bounds::bench {

/// At most 16 of all robots in LINK_BOUNDS_DATA, or of some of them if `quick`; see chooseMeshes().
MeasuredMeshes sharedMeshes(bool quick);

}  // namespace link_bounds::bench
