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

/// For the links of a robot: at most 16 of the meshes with a table, of all robots, or of some of
/// them if `quick`.
MeasuredMeshes sharedMeshes(bool quick);

/// Adds meshes that are hard for a table of directions: large flat faces of many vertices, and a
/// sphere, whose vertices can all be extreme.
void addSyntheticMeshes(MeasuredMeshes& meshes);

}  // namespace link_bounds::bench
