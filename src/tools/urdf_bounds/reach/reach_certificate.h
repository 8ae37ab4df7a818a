// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What --certificate writes with --reach.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>

#include "robot/reach/reach.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// Writes why the link of each reach never leaves a box, which is larger than that of the reach by
/// up to --accuracy, or by more where a table of 64 cells does not suffice. Returns for how many
/// links the file has no reason: they have no reach, too many joints move them, or `is_over` said
/// so. `out` is that of beginCertificate(). Throws UsageError if it cannot be written.
std::size_t writeReachCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                                  const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges,
                                  const std::vector<std::optional<Reach>>& reaches,
                                  const std::function<bool()>& is_over, std::ofstream& out);

}  // namespace link_bounds
