// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A repetition is a turn of each method, in random order.
#include "bench/pipeline/contest.h"

#include <algorithm>
#include <optional>
#include <random>
#include <stdexcept>

#include "bench/common/cold.h"
#include "bench/common/timing.h"
#include "bench/pipeline/tf_traffic.h"

namespace link_bounds::bench {
namespace {

constexpr double kTurn = 0.02;  // seconds

/// One method and the messages it is fed with.
class Competitor {
 public:
  Competitor(NamedPipeline named, const TfRobot& robot, Caches caches)
      : named_(std::move(named)), traffic_(robot, named_.moves), caches_(caches) {
    for (std::size_t i = 0; i < TfTraffic::kHistory; i += TfTraffic::kMessages) {
      traffic_.prepare();
      for (std::size_t k = 0; k < TfTraffic::kMessages; ++k)
        named_.pipeline->receive(traffic_.bytes(k), traffic_.stamp(k));
    }
    batch();
    // A batch of cold updates takes longer than a turn, nearly all of it for emptying the caches.
    if (caches_ == Caches::kWarm) batches_ = std::max(1, static_cast<int>(kTurn / batch()));
  }

  const std::string& method() const { return named_.method; }

  /// CPU seconds per update.
  double turn() {
    double seconds = 0;
    for (int i = 0; i < batches_; ++i)
      seconds += batch();
    return seconds / batches_ / static_cast<double>(TfTraffic::kMessages);
  }

 private:
  double batch() {
    traffic_.prepare();
    return caches_ == Caches::kCold ? coldBatch() : warmBatch();
  }

  double warmBatch() {
    const double start = threadSeconds();
    for (std::size_t k = 0; k < TfTraffic::kMessages; ++k)
      named_.pipeline->answer(traffic_.bytes(k), traffic_.stamp(k));
    return threadSeconds() - start;
  }

  /// The clock is read twice before each update, because its own code was put out of the caches.
  double coldBatch() {
    double seconds = 0;
    for (std::size_t k = 0; k < TfTraffic::kMessages; ++k) {
      emptyCaches();
      threadSeconds();
      const double start = threadSeconds();
      named_.pipeline->answer(traffic_.bytes(k), traffic_.stamp(k));
      seconds += threadSeconds() - start;
    }
    return seconds;
  }

  NamedPipeline named_;
  TfTraffic traffic_;
  Caches caches_;
  int batches_ = 1;
};

/// The same numbers. Throws if they are not.
void expectSame(const AxisAlignedBoxArray& boxes, const AxisAlignedBoxArray& others,
                const std::string& method) {
  bool is_same = boxes.boxes.size() == others.boxes.size();
  for (std::size_t i = 0; is_same && i < boxes.boxes.size(); ++i) {
    const AxisAlignedBox &a = boxes.boxes[i], &b = others.boxes[i];
    is_same = a.name == b.name && a.stamp == b.stamp && a.min.x == b.min.x && a.min.y == b.min.y &&
              a.min.z == b.min.z && a.max.x == b.max.x && a.max.y == b.max.y && a.max.z == b.max.z;
  }
  if (!is_same) throw std::runtime_error(method + " has other boxes than ours");
}

/// All that are exact must answer the same messages with the same boxes.
void compareBoxes(const TfRobot& robot, const MeasuredMeshes& meshes) {
  std::vector<NamedPipeline> pipelines = makePipelines(robot, meshes);
  TfTraffic traffic(robot, true);
  traffic.prepare();
  for (std::size_t k = 0; k < TfTraffic::kMessages; ++k) {
    std::optional<AxisAlignedBoxArray> expected;
    for (NamedPipeline& named : pipelines) {
      named.pipeline->answer(traffic.bytes(k), traffic.stamp(k));
      const AxisAlignedBoxArray* boxes = named.pipeline->boxes();
      if (!boxes) continue;
      if (!expected) expected = *boxes;
      expectSame(*expected, *boxes, named.method);
    }
  }
}

}  // namespace

Contest contest(std::size_t links, std::size_t depth, const MeasuredMeshes& meshes, int repetitions,
                Caches caches) {
  const TfRobot robot = tfRobot(links, depth);
  compareBoxes(robot, meshes);
  std::vector<Competitor> contenders;
  for (NamedPipeline& pipeline : makePipelines(robot, meshes))
    contenders.emplace_back(std::move(pipeline), robot, caches);
  Contest result{links, depth, {}};
  std::mt19937 engine(1);
  for (int i = 0; i < repetitions; ++i) {
    std::shuffle(contenders.begin(), contenders.end(), engine);
    for (Competitor& contender : contenders) {
      const double seconds = contender.turn();
      result.ns_per_link[contender.method()].push_back(1e9 * seconds / static_cast<double>(links));
    }
  }
  return result;
}

}  // namespace link_bounds::bench
