// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All pipelines on one robot, in turns, so that what slows the machine down strikes none more than
// others.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/common/measured_mesh.h"

namespace link_bounds::bench {

/// What one robot gave: per method the CPU time [ns] per link and update, once per repetition.
struct Contest {
  std::size_t links;
  std::size_t depth;
  std::map<std::string, std::vector<double>> ns_per_link;
};

/// Whether the caches are emptied before each measured update.
enum class Caches { kWarm, kCold };

/// `meshes` are shared by the links. Histories hold the ten seconds of tf at 1 kHz before anything
/// is measured.
Contest contest(std::size_t links, std::size_t depth, const MeasuredMeshes& meshes, int repetitions,
                Caches caches);

}  // namespace link_bounds::bench
