// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses, judgement, and the collection of times.
#include "core_suite.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr int kPoses = 1024;
constexpr std::size_t kJudged = 64;
constexpr double kExactTolerance = 1e-6;  ///< of the box's size: also single precision counts

/// Takes the times out of Google Benchmark instead of printing them.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const double items = run.counters.at("items");
      const auto index = static_cast<std::size_t>(run.counters.at("case"));
      cases()[index].ns.push_back(run.GetAdjustedCPUTime() / items);
    }
  }
};

}  // namespace

std::vector<Case>& cases() {
  static std::vector<Case> all;
  return all;
}

Task makeTask(const Mesh& mesh, bool turns) {
  brute_force::Random random(7);
  Task task{mesh, {}, {}};
  const Eigen::Affine3d fixed = random.rigid(1);
  Eigen::Affine3d slow = random.rigid(1);
  const Eigen::AngleAxisd step(0.01, random.vector(1).normalized());
  for (int i = 0; i < kPoses; ++i) {
    Eigen::Affine3d pose = i < kPoses / 2 ? random.rigid(1) : slow;
    if (!turns) pose.linear() = fixed.linear();
    task.poses.push_back(pose);
    slow = slow * step;
    slow.translation() += Eigen::Vector3d::Constant(1e-3);
  }
  for (std::size_t i = 0; i < kJudged; ++i)
    task.exact.push_back(brute_force::box(mesh.mesh.vertices, task.poses[i]));
  return task;
}

Quality judge(const std::vector<Aabb>& boxes, const std::vector<Aabb>& exact) {
  Quality quality{true, 0};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double tolerance = kExactTolerance * exact[i].sizes().maxCoeff();
    const double error = std::max((boxes[i].min() - exact[i].min()).lpNorm<Eigen::Infinity>(),
                                  (boxes[i].max() - exact[i].max()).lpNorm<Eigen::Infinity>());
    quality.exact = quality.exact && error <= tolerance;
    quality.volume_ratio += boxes[i].volume() / exact[i].volume();
  }
  quality.volume_ratio /= static_cast<double>(exact.size());
  return quality;
}

void registerCase(Case row, std::function<void(benchmark::State&)> body, int items) {
  const std::size_t index = cases().size();
  benchmark::RegisterBenchmark((row.mesh + "/" + row.method).c_str(),
                               [body, index, items](benchmark::State& state) {
                                 body(state);
                                 state.counters["case"] = static_cast<double>(index);
                                 state.counters["items"] = items;
                               });
  cases().push_back(std::move(row));
}

void runCases(int repetitions, double seconds_per_repetition) {
  std::vector<std::string> arguments{
      "core_bench", "--benchmark_enable_random_interleaving=true",
      "--benchmark_repetitions=" + std::to_string(repetitions),
      "--benchmark_min_time=" + std::to_string(seconds_per_repetition)};
  std::vector<char*> pointers;
  for (std::string& argument : arguments)
    pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
}

}  // namespace link_bounds::bench
