// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the bytes of a TFMessage to boxes: pipeline_bench [--cold] [--quick] [--json FILE]
#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>

#include "bench/common/benchmark_main.h"
#include "bench/common/machine.h"
#include "bench/common/result.h"
#include "bench/common/target.h"
#include "bench/pipeline/cold_stages.h"
#include "bench/pipeline/contest.h"
#include "bench/pipeline/shared_meshes.h"

namespace link_bounds::bench {
namespace {

constexpr std::array<std::size_t, 4> kLinkCounts{7, 50, 200, 1000};
constexpr std::array<std::size_t, 2> kDepths{10, 30};
constexpr std::array<const char*, 7> kMethods{"deserialize", "relay",       "ours_standing", "ours",
                                              "time_cache",  "buffer_core", "usual_tf2"};
constexpr std::size_t kMaxTargetLinks = 200;
constexpr std::array<std::size_t, 3> kColdLinkCounts{50, 200, 1000};
constexpr std::size_t kColdDepth = 10;

double medianOf(const Contest& contest, const std::string& method) {
  return median(contest.ns_per_link.at(method));
}

void printRow(const Contest& contest, std::ostream& out) {
  out << std::setw(7) << contest.links << std::setw(7) << contest.depth;
  for (const char* method : kMethods)
    out << std::setw(15) << medianOf(contest, method);
  out << "\n";
}

void printHead(std::ostream& out) {
  out << "CPU: " << cpuName() << "\n\nns per link and update\n  links  depth";
  for (const char* method : kMethods)
    out << std::setw(15) << method;
  out << "\n" << std::fixed << std::setprecision(1);
}

/// Ratios of one repetition each.
std::vector<double> ratiosOf(const std::vector<double>& times, const std::vector<double>& others) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.size(); ++i)
    ratios.push_back(times[i] / others[i]);
  return ratios;
}

void printTargets(const Contest& contest, std::ostream& out) {
  const std::string where =
      ", " + std::to_string(contest.links) + " links, depth " + std::to_string(contest.depth);
  const auto& times = contest.ns_per_link;
  const auto ratio = [&](const char* method, const char* other) {
    return ratiosOf(times.at(method), times.at(other));
  };
  const auto show = [&out](const Target& target) {
    print(target, "repetition", "repetitions", out);
  };
  if (contest.links <= kMaxTargetLinks)
    show({"ours / deserialize" + where, Wanted::kAtMost, 4, ratio("ours", "deserialize")});
  show({"usual_tf2 / ours" + where, Wanted::kAtLeast, 10, ratio("usual_tf2", "ours")});
}

void printColdTargets(const Contest& contest, std::ostream& out) {
  if (contest.links > kMaxTargetLinks) return;
  const std::string where = ", " + std::to_string(contest.links) + " links";
  const auto& times = contest.ns_per_link;
  print({"cold: ours / deserialize" + where, Wanted::kAtMost, 4,
         ratiosOf(times.at("ours"), times.at("deserialize"))},
        "repetition", "repetitions", out);
  print({"cold: usual_tf2 / ours" + where, Wanted::kAtLeast, 6,
         ratiosOf(times.at("usual_tf2"), times.at("ours"))},
        "repetition", "repetitions", out);
}

/// From 50 to 1000 links; the repetitions of different robots are not from the same moment.
void printGrowth(const std::vector<Contest>& contests, std::size_t depth, std::ostream& out) {
  const auto find = [&](std::size_t links) {
    return std::find_if(contests.begin(), contests.end(), [&](const Contest& contest) {
      return contest.links == links && contest.depth == depth;
    });
  };
  const auto few = find(50);
  const auto many = find(1000);
  if (many == contests.end()) return;
  print({"ours per link, 1000 links / 50 links, depth " + std::to_string(depth), Wanted::kAtMost, 3,
         ratiosOf(many->ns_per_link.at("ours"), few->ns_per_link.at("ours"))},
        "repetition", "repetitions", out);
}

/// The rows of a JSON list, without its end.
void writeJson(const std::vector<Contest>& contests, std::ostream& out) {
  const char* separator = "[\n";
  for (const Contest& contest : contests) {
    for (const char* method : kMethods) {
      out << separator << "{\"method\": \"" << method << "\", \"links\": " << contest.links
          << ", \"depth\": " << contest.depth << ", \"ns_per_link\": " << medianOf(contest, method)
          << "}";
      separator = ",\n";
    }
  }
}

void printStages(std::size_t links, const std::vector<StageTime>& stages, std::ostream& out) {
  out << "\nours by stage, " << links << " links, ns per link\n";
  for (const StageTime& stage : stages)
    out << "  " << std::left << std::setw(20) << stage.name << std::right << std::setw(10)
        << stage.ns_per_link << "\n";
  out << std::flush;
}

/// Rows after others.
void writeStages(std::size_t links, const std::vector<StageTime>& stages, std::ostream& out) {
  for (const StageTime& stage : stages)
    out << ",\n{\"stage\": \"" << stage.name << "\", \"links\": " << links
        << ", \"ns_per_link\": " << stage.ns_per_link << "}";
}

void benchmarkPipeline(bool quick, std::ostream* json) {
  const MeasuredMeshes meshes = sharedMeshes(false, std::cout);
  printHead(std::cout);
  std::vector<Contest> contests;
  for (const std::size_t links : kLinkCounts) {
    for (const std::size_t depth : kDepths) {
      if (quick && links > kMaxTargetLinks) continue;
      contests.push_back(contest(links, depth, meshes, quick ? 5 : 15, Caches::kWarm));
      printRow(contests.back(), std::cout);
      std::cout << std::flush;
    }
  }
  std::cout << "\nTargets\n" << std::setprecision(2);
  for (const Contest& contest : contests)
    printTargets(contest, std::cout);
  for (const std::size_t depth : kDepths)
    printGrowth(contests, depth, std::cout);
  if (!json) return;
  writeJson(contests, *json);
  *json << "\n]\n";
}

void benchmarkCold(bool quick, std::ostream* json) {
  const MeasuredMeshes meshes = sharedMeshes(false, std::cout);
  std::cout << "The caches are emptied before each update.\n";
  printHead(std::cout);
  std::vector<Contest> contests;
  for (const std::size_t links : kColdLinkCounts) {
    if (quick && links > kMaxTargetLinks) continue;
    contests.push_back(contest(links, kColdDepth, meshes, quick ? 5 : 15, Caches::kCold));
    printRow(contests.back(), std::cout);
    std::cout << std::flush;
  }
  if (json) writeJson(contests, *json);
  for (const Contest& contest : contests) {
    const auto stages = coldStages(contest.links, kColdDepth, meshes, quick ? 64 : 256);
    printStages(contest.links, stages, std::cout);
    if (json) writeStages(contest.links, stages, *json);
  }
  if (json) *json << "\n]\n";
  std::cout << "\nTargets\n" << std::setprecision(2);
  for (const Contest& contest : contests)
    printColdTargets(contest, std::cout);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkPipeline,
                                          link_bounds::bench::benchmarkCold);
}
