// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which meshes are measured.
#pragma once

#include "bench/common/measured_mesh.h"

namespace link_bounds::bench {

/// Every visual mesh of the robots of LINK_BOUNDS_DATA, the scanned models there, and computed
/// meshes; with `quick` some of each. Where it is not set the meshes of the demo stand in for
/// robots, and there are no models. Prints what is left out.
MeasuredMeshes chooseMeshes(bool quick);

}  // namespace link_bounds::bench
