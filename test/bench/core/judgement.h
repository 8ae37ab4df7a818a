// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How good boxes are, beside those of a scan over all vertices.
#pragma once

#include <vector>

#include "bench/common/poses.h"
#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/mesh/triangle_mesh.h"

namespace link_bounds::bench {

using Boxes = std::vector<Aabb>;

/// The exact boxes under the first kRandomPoses of the poses.
Boxes exactBoxes(const TriangleMesh& mesh, const Poses& poses);

struct Judgement {
  bool exact;           ///< to 1e-9 of the box's longest side
  double volume_ratio;  ///< mean of box / exact box
};

Judgement judge(const Boxes& boxes, const Boxes& exact);

}  // namespace link_bounds::bench
