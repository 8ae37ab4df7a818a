// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are hard for a table of directions: large flat faces of many vertices, and a sphere,
// whose vertices can all be extreme.
#pragma once

#include "bench/common/measured_mesh.h"

namespace link_bounds::bench {

void addSyntheticMeshes(MeasuredMeshes& meshes);

}  // namespace link_bounds::bench
