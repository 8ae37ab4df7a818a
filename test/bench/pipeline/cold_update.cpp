// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A few updates of the node, for Valgrind's Callgrind, whose model of a cache is empty whenever it
// begins to watch: cold_update LINKS UPDATES
#include <valgrind/callgrind.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "bench/common/mesh_choice.h"
#include "bench/pipeline/node_update.h"
#include "bench/pipeline/shared_meshes.h"
#include "bench/pipeline/tf_traffic.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kDepth = 10;
constexpr std::size_t kHistory = 10000;  // messages: 10 s at 1 kHz, so that memory is reused
constexpr std::size_t kWarm = 16;        // messages: so that all memory is there

void watch(NodeUpdate& update, Bytes& bytes, ros::Time now) {
  CALLGRIND_START_INSTRUMENTATION;
  update.answer(bytes, now);
  CALLGRIND_STOP_INSTRUMENTATION;
}

void run(std::size_t links, std::size_t updates) {
  const MeasuredMeshes meshes = sharedMeshes(true, std::cerr);
  const TfRobot robot = tfRobot(links, kDepth);
  NodeUpdate update(modelOf(robot, meshes));
  TfTraffic traffic(robot, true);
  for (std::size_t i = 0; i < kHistory + kWarm + updates; ++i) {
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
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: cold_update LINKS UPDATES");
  link_bounds::bench::run(std::stoul(argv[1]), std::stoul(argv[2]));
  return 0;
} catch (const std::exception& error) {
  std::cerr << "cold_update: " << error.what() << "\n";
  return 1;
}
