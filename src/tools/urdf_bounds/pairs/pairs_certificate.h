// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The file of --certificate. doc/tools.md describes it.
#pragma once

#include <iosfwd>

#include "robot/pairs/pair_proofs.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes why each pair of `proofs` never collides, always does or always touches. Returns for how
/// many of these the file has no reason: the reason would be too long, or `is_over` said so. `out`
/// is that of beginCertificate(). Throws UsageError if it cannot be written.
std::size_t writeCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                             const BoundedRobot& bounded, const std::vector<JointRange>& ranges,
                             const std::vector<PairProof>& proofs,
                             const std::function<bool()>& is_over, std::ofstream& out);

}  // namespace link_bounds
