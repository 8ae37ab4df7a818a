// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A repetition is a turn of each method, in random order.
#include "contest.h"

#include <time.h>

#include <algorithm>
#include <random>

#include "tf_traffic.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kHistory = 10000;  // messages
constexpr double kTurn = 0.02;           // seconds

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

/// One method and the messages it is fed with.
class Contender {
 public:
  Contender(NamedPipeline named, const TfRobot& robot)
      : named_(std::move(named)), traffic_(robot, named_.moves) {
    for (std::size_t i = 0; i < kHistory; i += TfTraffic::kMessages) {
      traffic_.prepare();
      for (std::size_t k = 0; k < TfTraffic::kMessages; ++k)
        named_.pipeline->receive(traffic_.bytes(k), traffic_.stamp(k));
    }
    batch();
    batches_ = std::max(1, static_cast<int>(kTurn / batch()));
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
    const double start = cpuSeconds();
    for (std::size_t k = 0; k < TfTraffic::kMessages; ++k)
      named_.pipeline->answer(traffic_.bytes(k), traffic_.stamp(k));
    return cpuSeconds() - start;
  }

  NamedPipeline named_;
  TfTraffic traffic_;
  int batches_ = 1;
};

}  // namespace

Contest contest(std::size_t links, std::size_t depth, const MeasuredMeshes& meshes,
                int repetitions) {
  const TfRobot robot = tfRobot(links, depth);
  std::vector<Contender> contenders;
  for (NamedPipeline& pipeline : makePipelines(robot, meshes))
    contenders.emplace_back(std::move(pipeline), robot);
  Contest result{links, depth, {}};
  std::mt19937 engine(1);
  for (int i = 0; i < repetitions; ++i) {
    std::shuffle(contenders.begin(), contenders.end(), engine);
    for (Contender& contender : contenders) {
      const double seconds = contender.turn();
      result.ns_per_link[contender.method()].push_back(1e9 * seconds / static_cast<double>(links));
    }
  }
  return result;
}

}  // namespace link_bounds::bench
