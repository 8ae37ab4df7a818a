// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The first line of a certificate.
#pragma once

#include <iosfwd>

#include "link_bounds/robot/urdf/robot.h"
#include "tools/urdf_bounds/urdf_bounds_options.h"

namespace link_bounds {

/// `kind` is what it is about: pairs, reach or path.
void writeCertificateHead(const char* kind, const UrdfBoundsOptions& options, const Robot& robot,
                          std::ostream& out);

}  // namespace link_bounds
