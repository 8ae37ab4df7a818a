// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/link_distances.h"

namespace link_bounds {

DistanceTable linkDistances(PosedRobot& posed, const BoundedRobot& bounded, double limit) {
  const PoseDistances found = posed.distances(limit);
  DistanceTable table{limit, {}, {}, posed.hasPairs()};
  for (const LinkPairDistance& pair : found.pairs)
    table.pairs.push_back(
        {bounded.links[pair.first].name, bounded.links[pair.second].name, pair.distance});
  for (const std::size_t link : found.unmeasured)
    table.incomplete.emplace_back(bounded.links[link].name,
                                  "its size and pose give no finite distance");
  return table;
}

}  // namespace link_bounds
