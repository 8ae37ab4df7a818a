// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which meshes are measured.
#pragma once

#include <iosfwd>
#include <string>

#include "bench/common/measured_mesh.h"

namespace link_bounds::bench {

/// Every visual mesh of the robots of LINK_BOUNDS_DATA, the scanned models there, and computed
/// meshes; with `quick` some of each. Where it is not set the meshes of `demo_folder` stand in for
/// robots, and there are no models. What is left out is said in `notes`.
MeasuredMeshes chooseMeshes(const std::string& demo_folder, bool quick, std::ostream& notes);

}  // namespace link_bounds::bench
