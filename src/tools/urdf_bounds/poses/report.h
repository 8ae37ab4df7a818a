// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The volumes of links on standard output.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/bounded_link.h"
#include "tools/urdf_bounds/poses/distance_table.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

struct PlacedLink {
  const BoundedLink* link;
  Eigen::Isometry3d frame_from_link;
};

/// Writes the volume that the options name of each link, in `frame`; of boxes also the one around
/// all. Adds `distances` if there are any. Returns the links whose volume or distance is missing or
/// does not cover everything, with the reason.
Reasons writeReport(const UrdfBoundsOptions& options, const std::string& frame,
                    const std::vector<PlacedLink>& links,
                    const std::optional<DistanceTable>& distances);

}  // namespace link_bounds
