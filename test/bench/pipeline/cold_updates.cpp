// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A few updates of the node, for Valgrind's Callgrind, whose model of a cache is empty whenever it
// begins to watch. Each number of links is a dump of its own.
#include <valgrind/callgrind.h>

#include <string>

#include "bench/common/benchmarks.h"
#include "bench/common/mesh_choice.h"
#include "bench/pipeline/cold_stages.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kDepth = 10;
constexpr std::size_t kWarm = 16;     // updates: so that all memory is there
constexpr std::size_t kUpdates = 14;  // twice as many as a block of a history has samples

void run(std::size_t links, const MeasuredMeshes& meshes) {
  std::size_t number = 0;
  const auto watch = [&number](NodeUpdate& update, Bytes& bytes, ros::Time now) {
    const bool is_watched = number++ >= kWarm;
    if (is_watched) CALLGRIND_START_INSTRUMENTATION;
    update.answer(bytes, now);
    if (is_watched) CALLGRIND_STOP_INSTRUMENTATION;
  };
  forUpdates(tfRobot(links, kDepth), meshes, kWarm + kUpdates, watch);
}

}  // namespace

Rows runColdUpdates(bool quick) {
  const MeasuredMeshes meshes = sharedMeshes(true);
  for (const std::size_t links : {50u, 200u}) {
    if (quick && links > 50) continue;
    run(links, meshes);
    CALLGRIND_DUMP_STATS_AT(std::to_string(links).c_str());
  }
  return {};
}

}  // namespace link_bounds::bench
