// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the file of --certificate with --path. doc/tools.md describes it.
#pragma once

#include <iosfwd>

#include "robot/posed/robot_path.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes a proof for each SAFE segment. `proofs` has one per motion. Returns the number of SAFE
/// segments without a proof: it would be too long or need too short intervals, its check fails
/// where nothing moves, or `is_over` stopped it. Ends and closes `out`, which comes from
/// beginCertificate(). Throws UsageError if the file cannot be written.
std::size_t writePathCertificate(const UrdfBoundsOptions& options, const Robot& simple,
                                 const PathBodies& bodies, const std::vector<JointMotion>& motions,
                                 const std::vector<SegmentProof>& proofs,
                                 const std::function<bool()>& is_over, std::ofstream& out);

}  // namespace link_bounds
