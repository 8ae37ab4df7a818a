// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From urdfdom's geometry of a link to plain values.
#pragma once

#include <urdf_model/link.h>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// The rotation is normalised.
Eigen::Isometry3d toIsometry(const urdf::Pose& pose);

Eigen::Vector3d toVector(const urdf::Vector3& vector);

/// The link with every visual and collision element. Those with unusable numbers are in Link::lost.
Link toLink(const urdf::Link& source);

}  // namespace link_bounds
