// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What --certificate writes with --path. doc/tools.md describes it.
#pragma once

#include <iosfwd>

#include "robot/posed/robot_path.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes why each SAFE segment is safe. `proofs` has one per motion. Returns for how many of these
/// the file has no reason: the reason would be too long, or `is_over` said so. `out` is that of
/// beginCertificate(). Throws UsageError if it cannot be written.
std::size_t writePathCertificate(const UrdfBoundsOptions& options, const Robot& simple,
                                 const PathBodies& bodies, const std::vector<JointMotion>& motions,
                                 const std::vector<SegmentProof>& proofs,
                                 const std::function<bool()>& is_over, std::ofstream& out);

}  // namespace link_bounds
