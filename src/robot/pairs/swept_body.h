// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a body fills while it turns about an axis.
#pragma once

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// Cylinders about an axis through the origin that hold the body at any angle. `pose` places the
/// body; `axis` is a unit vector.
Body sweptBody(const Body& body, const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis);

}  // namespace link_bounds
