// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the time of an update goes that starts with empty caches.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/pipeline/node_update.h"

namespace link_bounds::bench {

/// Runs that many updates. Histories are full before.
void forUpdates(const TfRobot& robot, const MeasuredMeshes& meshes, std::size_t updates,
                const std::function<void(NodeUpdate&, Bytes&, ros::Time)>& run);

struct StageTime {
  std::string name;
  double ns_per_link;  ///< median of the updates
};

/// The stages of NodeUpdate, in order.
std::vector<StageTime> coldStages(const TfRobot& robot, const MeasuredMeshes& meshes,
                                  std::size_t updates);

}  // namespace link_bounds::bench
