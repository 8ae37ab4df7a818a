// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One clock for all stages: the end of one is the begin of the next.
#include "bench/pipeline/cold_stages.h"

#include <chrono>

#include "bench/common/cold.h"
#include "bench/common/result.h"
#include "bench/pipeline/tf_traffic.h"

namespace link_bounds::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Appends to `times` how long each stage takes [ns].
void measure(NodeUpdate& update, Bytes& bytes, ros::Time now,
             std::vector<std::vector<double>>& times) {
  emptyCaches();
  Clock::now();
  Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < NodeUpdate::kStages.size(); ++i) {
    (update.*NodeUpdate::kStages[i].run)(bytes, now);
    const Clock::time_point end = Clock::now();
    times[i].push_back(std::chrono::duration<double, std::nano>(end - start).count());
    start = end;
  }
}

}  // namespace

void forUpdates(const TfRobot& robot, const MeasuredMeshes& meshes, std::size_t updates,
                const std::function<void(NodeUpdate&, Bytes&, ros::Time)>& run) {
  NodeUpdate update(modelOf(robot, meshes));
  TfTraffic traffic(robot, true);
  for (std::size_t i = 0; i < TfTraffic::kHistory + updates; ++i) {
    const std::size_t k = i % TfTraffic::kMessages;
    if (k == 0) traffic.prepare();
    if (i < TfTraffic::kHistory) {
      update.receive(traffic.bytes(k), traffic.stamp(k));
    } else {
      run(update, traffic.bytes(k), traffic.stamp(k));
    }
  }
}

std::vector<StageTime> coldStages(const TfRobot& robot, const MeasuredMeshes& meshes,
                                  std::size_t updates) {
  std::vector<std::vector<double>> times(NodeUpdate::kStages.size());
  forUpdates(robot, meshes, updates, [&](NodeUpdate& update, Bytes& bytes, ros::Time now) {
    measure(update, bytes, now, times);
  });
  std::vector<StageTime> result;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double ns = median(times[i]) / static_cast<double>(robot.links.size());
    result.push_back({NodeUpdate::kStages[i].name, ns});
  }
  return result;
}

}  // namespace link_bounds::bench
