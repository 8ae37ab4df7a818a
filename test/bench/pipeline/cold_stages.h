// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the time of an update goes that starts with empty caches.
#pragma once

#include <string>
#include <vector>

#include "bench/common/measured_mesh.h"

namespace link_bounds::bench {

struct StageTime {
  std::string name;
  double ns_per_link;  ///< median of the updates
};

/// The stages of NodeUpdate, in order. Histories are full before.
std::vector<StageTime> coldStages(std::size_t links, std::size_t depth,
                                  const MeasuredMeshes& meshes, std::size_t updates);

}  // namespace link_bounds::bench
