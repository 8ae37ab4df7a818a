// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the bytes of a TFMessage to boxes: pipeline_bench [--quick] [--json FILE]
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "benchmark_main.h"
#include "contest.h"
#include "geometry/support/direction_table.h"
#include "machine.h"
#include "mesh_choice.h"
#include "result.h"
#include "target.h"

namespace link_bounds::bench {
namespace {

constexpr std::array<std::size_t, 4> kLinkCounts{7, 50, 200, 1000};
constexpr std::array<std::size_t, 2> kDepths{10, 30};
constexpr std::array<const char*, 7> kMethods{"deserialize", "relay",       "ours_standing", "ours",
                                              "time_cache",  "buffer_core", "usual_tf2"};
constexpr std::size_t kMostLinksOfATarget = 200;
constexpr std::size_t kSharedMeshes = 16;

/// Some of all robots.
MeasuredMeshes sharedMeshes(std::ostream& notes) {
  const char* data = std::getenv("LINK_BOUNDS_DATA");
  MeasuredMeshes meshes = chooseMeshes(data ? data : "", LINK_BOUNDS_DEMO_MESHES, false, notes);
  const auto end = std::remove_if(meshes.begin(), meshes.end(), [](const MeasuredMesh& mesh) {
    return mesh.kind != "robot" || mesh.points->size() <= kScannedPoints;
  });
  meshes.erase(end, meshes.end());
  const std::size_t wanted = std::min(meshes.size(), kSharedMeshes);
  MeasuredMeshes chosen;
  for (std::size_t i = 0; i < wanted; ++i)
    chosen.push_back(std::move(meshes[i * meshes.size() / wanted]));
  return chosen;
}

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
  if (contest.links <= kMostLinksOfATarget)
    show({"ours / deserialize" + where, Wanted::kAtMost, 4, ratio("ours", "deserialize")});
  show({"usual_tf2 / ours" + where, Wanted::kAtLeast, 10, ratio("usual_tf2", "ours")});
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
  out << "\n]\n";
}

void benchmarkPipeline(bool quick, std::ostream* json) {
  const MeasuredMeshes meshes = sharedMeshes(std::cout);
  printHead(std::cout);
  std::vector<Contest> contests;
  for (const std::size_t links : kLinkCounts) {
    for (const std::size_t depth : kDepths) {
      if (quick && links > kMostLinksOfATarget) continue;
      contests.push_back(contest(links, depth, meshes, quick ? 5 : 15));
      printRow(contests.back(), std::cout);
      std::cout << std::flush;
    }
  }
  std::cout << "\nTargets\n" << std::setprecision(2);
  for (const Contest& contest : contests)
    printTargets(contest, std::cout);
  for (const std::size_t depth : kDepths)
    printGrowth(contests, depth, std::cout);
  if (json) writeJson(contests, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::benchmarkPipeline);
}
