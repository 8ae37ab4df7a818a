// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The first line of a certificate, and how much one claims.
#pragma once

#include <iosfwd>

#include "link_bounds/robot/urdf/robot.h"
#include "tools/urdf_bounds/urdf_bounds_options.h"

namespace link_bounds {

/// Of the clearance that was proven. All of it would take a hundred times as many boxes or
/// intervals, most of them near the nearest pose.
constexpr double kClaimed = 0.5;

/// `kind` is what it is about: pairs, reach or path.
void writeCertificateHead(const char* kind, const UrdfBoundsOptions& options, const Robot& robot,
                          std::ostream& out);

}  // namespace link_bounds
