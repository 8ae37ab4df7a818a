// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the file of --certificate with --reach.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>

#include "robot/reach/reach.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes for each link a proof that it never leaves a box. That box exceeds the one in `reaches`
/// by at most --accuracy, or by more if a table of 64 cells is too coarse. Returns the number of
/// links without a proof: geometry or reach is missing, too many joints move them, or `is_over`
/// stopped the proof. `out` comes from beginCertificate(). Throws UsageError if it cannot be
/// written.
std::size_t writeReachCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                                  const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges,
                                  const std::vector<std::optional<Reach>>& reaches,
                                  const std::function<bool()>& is_over, std::ofstream& out);

}  // namespace link_bounds
