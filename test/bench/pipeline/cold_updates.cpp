// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A few updates of the node, for Valgrind's Callgrind, whose model of a cache is empty whenever it
// begins to watch. Each number of links is a dump of its own.
#include <valgrind/callgrind.h>

#include <string>

#include "bench/common/benchmarks.h"
#include "bench/pipeline/node_update.h"
#include "bench/pipeline/shared_meshes.h"
#include "bench/pipeline/tf_traffic.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kDepth = 10;
constexpr std::size_t kHistory = 10000;  // messages: 10 s at 1 kHz, so that memory is reused
constexpr std::size_t kWarm = 16;        // messages: so that all memory is there
constexpr std::size_t kUpdates = 14;     // twice as many as a block of a history has samples

void watch(NodeUpdate& update, Bytes& bytes, ros::Time now) {
  CALLGRIND_START_INSTRUMENTATION;
  update.answer(bytes, now);
  CALLGRIND_STOP_INSTRUMENTATION;
}

void run(std::size_t links, const MeasuredMeshes& meshes) {
  const TfRobot robot = tfRobot(links, kDepth);
  NodeUpdate update(modelOf(robot, meshes));
  TfTraffic traffic(robot, true);
  for (std::size_t i = 0; i < kHistory + kWarm + kUpdates; ++i) {
    const std::size_t k = i % TfTraffic::kMessages;
    if (k == 0) traffic.prepare();
    if (i < kHistory) {
      update.receive(traffic.bytes(k), traffic.stamp(k));
    } else if (i < kHistory + kWarm) {
      update.answer(traffic.bytes(k), traffic.stamp(k));
    } else {
      watch(update, traffic.bytes(k), traffic.stamp(k));
    }
  }
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
