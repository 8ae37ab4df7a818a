// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From the bytes of a TFMessage to boxes.
#include <algorithm>
#include <array>
#include <iostream>

#include "bench/common/benchmarks.h"
#include "bench/common/mesh_choice.h"
#include "bench/common/result.h"
#include "bench/common/table.h"
#include "bench/common/target.h"
#include "bench/pipeline/cold_stages.h"
#include "bench/pipeline/contest.h"

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

/// One row per method.
Rows rowsOf(const Contest& contest) {
  Rows rows;
  for (const char* method : kMethods) {
    rows.push_back({{"method", method},
                    {"links", contest.links},
                    {"depth", contest.depth},
                    {"ns_per_link", medianOf(contest, method)}});
  }
  return rows;
}

/// Measures contests, and prints each as a row with a column per method.
class ContestTable {
 public:
  void add(Contest contest) {
    const Rows rows = rowsOf(contest);
    for (const Row& row : pivot(rows, {"links", "depth"}, "method", "ns_per_link"))
      table_.add(row);
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    contests_.push_back(std::move(contest));
  }

  const std::vector<Contest>& contests() const { return contests_; }
  const Rows& rows() const { return rows_; }

 private:
  static std::vector<Column> columns() {
    std::vector<Column> columns{{"links"}, {"depth"}};
    for (const char* method : kMethods)
      columns.push_back({method});
    return columns;
  }

  Table table_{"ns per link and update", columns()};
  std::vector<Contest> contests_;
  Rows rows_;
};

/// Ratios of one repetition each.
std::vector<double> ratiosOf(const std::vector<double>& times, const std::vector<double>& others) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.size(); ++i)
    ratios.push_back(times[i] / others[i]);
  return ratios;
}

std::vector<Target> targetsOf(const Contest& contest) {
  const std::string where =
      ", " + std::to_string(contest.links) + " links, depth " + std::to_string(contest.depth);
  const auto& times = contest.ns_per_link;
  std::vector<Target> targets;
  if (contest.links <= kMaxTargetLinks)
    targets.push_back({"ours / deserialize" + where, Wanted::kAtMost, 4,
                       ratiosOf(times.at("ours"), times.at("deserialize"))});
  targets.push_back({"usual_tf2 / ours" + where, Wanted::kAtLeast, 10,
                     ratiosOf(times.at("usual_tf2"), times.at("ours"))});
  return targets;
}

std::vector<Target> coldTargetsOf(const Contest& contest) {
  if (contest.links > kMaxTargetLinks) return {};
  const std::string where = ", " + std::to_string(contest.links) + " links";
  const auto& times = contest.ns_per_link;
  return {{"cold: ours / deserialize" + where, Wanted::kAtMost, 4,
           ratiosOf(times.at("ours"), times.at("deserialize"))},
          {"cold: usual_tf2 / ours" + where, Wanted::kAtLeast, 6,
           ratiosOf(times.at("usual_tf2"), times.at("ours"))}};
}

/// From 50 to 1000 links; the repetitions of different robots are not from the same moment.
std::vector<Target> growthOf(const std::vector<Contest>& contests, std::size_t depth) {
  const auto find = [&](std::size_t links) {
    return std::find_if(contests.begin(), contests.end(), [&](const Contest& contest) {
      return contest.links == links && contest.depth == depth;
    });
  };
  const auto few = find(50);
  const auto many = find(1000);
  if (many == contests.end()) return {};
  return {{"ours per link, 1000 links / 50 links, depth " + std::to_string(depth), Wanted::kAtMost,
           3, ratiosOf(many->ns_per_link.at("ours"), few->ns_per_link.at("ours"))}};
}

void append(const std::vector<Target>& more, std::vector<Target>& targets) {
  targets.insert(targets.end(), more.begin(), more.end());
}

/// One row per stage of ours.
Rows measureStages(std::size_t links, const MeasuredMeshes& meshes, bool quick) {
  const Table table("ours by stage, " + std::to_string(links) + " links",
                    {{"stage", "", 20}, {"ns_per_link", "ns per link"}});
  Rows rows;
  for (const StageTime& stage : coldStages(tfRobot(links, kColdDepth), meshes, quick ? 64 : 256)) {
    table.add(rows.emplace_back(
        Row{{"stage", stage.name}, {"links", links}, {"ns_per_link", stage.ns_per_link}}));
  }
  return rows;
}

}  // namespace

Rows benchmarkPipeline(bool quick) {
  const MeasuredMeshes meshes = sharedMeshes(false);
  ContestTable table;
  for (const std::size_t links : kLinkCounts) {
    for (const std::size_t depth : kDepths) {
      if (quick && links > kMaxTargetLinks) continue;
      table.add(contest(links, depth, meshes, quick ? 5 : 15, Caches::kWarm));
    }
  }
  std::vector<Target> targets;
  for (const Contest& contest : table.contests())
    append(targetsOf(contest), targets);
  for (const std::size_t depth : kDepths)
    append(growthOf(table.contests(), depth), targets);
  printTargets("", targets);
  return table.rows();
}

Rows benchmarkPipelineCold(bool quick) {
  const MeasuredMeshes meshes = sharedMeshes(false);
  std::cout << "The caches are emptied before each update.\n";
  ContestTable table;
  for (const std::size_t links : kColdLinkCounts) {
    if (quick && links > kMaxTargetLinks) continue;
    table.add(contest(links, kColdDepth, meshes, quick ? 5 : 15, Caches::kCold));
  }
  Rows rows = table.rows();
  std::vector<Target> targets;
  for (const Contest& contest : table.contests()) {
    const Rows stages = measureStages(contest.links, meshes, quick);
    rows.insert(rows.end(), stages.begin(), stages.end());
    append(coldTargetsOf(contest), targets);
  }
  printTargets("", targets);
  return rows;
}

}  // namespace link_bounds::bench
