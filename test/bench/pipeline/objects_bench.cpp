// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From markers that have arrived to boxes.
#include <malloc.h>

#include <memory>
#include <stdexcept>

#include "bench/common/benchmarks.h"
#include "bench/common/suite.h"
#include "bench/common/table.h"
#include "bench/common/target.h"
#include "link_bounds/geometry/shape/bounded_link.h"
#include "node/upkeep/heap.h"
#include "testing/brute_force.h"
#include "world/bodies/marker_refusal.h"
#include "world/bodies/marker_shape.h"

namespace link_bounds::bench {
namespace {

using visualization_msgs::Marker;
using MarkerPtr = std::shared_ptr<const Marker>;

struct NamedType {
  const char* name;
  int type;
};

constexpr NamedType kTypes[] = {{"TRIANGLE_LIST", Marker::TRIANGLE_LIST},
                                {"POINTS", Marker::POINTS},
                                {"LINE_STRIP", Marker::LINE_STRIP},
                                {"SPHERE_LIST", Marker::SPHERE_LIST}};
constexpr std::size_t kCounts[] = {999, 9'999, 99'999, 999'999};  // threes for triangles
constexpr std::size_t kFew = 9'999;
constexpr std::size_t kMany = 99'999;
const Eigen::Affine3d kTilted(brute_force::turned(30, {1, 2, 3}));

MarkerPtr makeMarker(int type, std::size_t points) {
  Marker marker;
  marker.header.frame_id = "frame";
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 0.1;
  brute_force::Random random(1);
  marker.points.resize(points);
  for (geometry_msgs::Point& point : marker.points) {
    point.x = random.uniform(-1, 1);
    point.y = random.uniform(-1, 1);
    point.z = random.uniform(-1, 1);
  }
  return std::make_shared<const Marker>(std::move(marker));
}

/// As the node does, with a message of its own.
BoundedLink makeObject(Marker message) {
  const std::string refusal = whyMarkerRefused(message);
  if (!refusal.empty()) throw std::runtime_error(refusal);
  return {"object", markerShape(std::move(message)).shapes, 0, ""};
}

/// As in the node: what a freed message took goes back to the system if it is large.
void useHeapOfNode() {
  constexpr int kDefault = 128 * 1024;  // bytes, of glibc
  mallopt(M_TRIM_THRESHOLD, kDefault);
  returnLargeBlocks();
}

/// Everything that is freed is kept for the next message.
void useHeapThatKeeps() {
  constexpr int kMax = 32 << 20;  // bytes, the largest value that glibc takes for blocks
  mallopt(M_TRIM_THRESHOLD, 2 * kMax);
  mallopt(M_MMAP_THRESHOLD, kMax);
}

/// The whole way from messages that have arrived, some at a time so that the watch need not be
/// stopped for each. As in the node, the old object goes when the new one is there.
void runWhole(const Marker& marker, benchmark::State& state) {
  const auto batch =
      static_cast<std::int64_t>(std::max<std::size_t>(1, kFew / marker.points.size()));
  BoundedLink object = makeObject(marker);
  while (state.KeepRunningBatch(batch)) {
    state.PauseTiming();
    std::vector<Marker> messages(static_cast<std::size_t>(batch), marker);
    state.ResumeTiming();
    for (Marker& message : messages) {
      object = makeObject(std::move(message));
      benchmark::DoNotOptimize(linkBox(object, kTilted));
    }
  }
}

void runOurs(const Marker& marker, benchmark::State& state) {
  useHeapOfNode();
  runWhole(marker, state);
}

/// What returning the memory costs is the difference to runOurs.
void runKept(const Marker& marker, benchmark::State& state) {
  useHeapThatKeeps();
  runWhole(marker, state);
}

/// Only the pose has changed.
void runRescan(const Marker& marker, benchmark::State& state) {
  const BoundedLink object = makeObject(marker);
  for (auto _ : state)
    benchmark::DoNotOptimize(linkBox(object, kTilted));
}

/// The box of the points where they are, as one would write it.
void runMinMax(const Marker& marker, benchmark::State& state) {
  for (auto _ : state) {
    geometry_msgs::Point low = marker.points.front();
    geometry_msgs::Point high = low;
    for (const geometry_msgs::Point& point : marker.points) {
      low.x = std::min(low.x, point.x);
      low.y = std::min(low.y, point.y);
      low.z = std::min(low.z, point.z);
      high.x = std::max(high.x, point.x);
      high.y = std::max(high.y, point.y);
      high.z = std::max(high.z, point.z);
    }
    benchmark::DoNotOptimize(low);
    benchmark::DoNotOptimize(high);
  }
}

using Body = void (*)(const Marker&, benchmark::State&);

void addCase(const NamedType& type, const MarkerPtr& marker, const char* method, Body body,
             Suite& suite) {
  Result result{};
  result.mesh = type.name + (":" + std::to_string(marker->points.size()));
  result.kind = type.name;
  result.vertices = marker->points.size();
  result.method = method;
  suite.push_back({result, [marker, body](benchmark::State& state) { body(*marker, state); }, 1});
}

Suite makeSuite() {
  Suite suite;
  for (const NamedType& type : kTypes) {
    for (const std::size_t count : kCounts) {
      const MarkerPtr marker = makeMarker(type.type, count);
      addCase(type, marker, "ours", runOurs, suite);
      addCase(type, marker, "ours_kept", runKept, suite);
      addCase(type, marker, "rescan", runRescan, suite);
      addCase(type, marker, "minmax", runMinMax, suite);
    }
  }
  return suite;
}

Rows rowsPerPoint(const Results& results) {
  Rows rows;
  for (const Result& result : results) {
    rows.push_back({{"method", result.method},
                    {"type", result.kind},
                    {"points", result.vertices},
                    {"ns_per_point", result.ns / static_cast<double>(result.vertices)}});
  }
  return rows;
}

std::vector<double> growth(const Results& results, const std::string& method) {
  std::vector<double> ratios;
  for (const NamedType& type : kTypes) {
    const std::string name = type.name;
    const auto ns = [&](std::size_t count) {
      return find(results, name + ":" + std::to_string(count), method)->ns;
    };
    ratios.push_back(ns(kMany) / ns(kFew));
  }
  return ratios;
}

std::vector<Target> targets(const Results& results) {
  const auto many = [](const Result& result) { return result.vertices == kMany; };
  std::vector<Target> targets;
  for (const std::string method : {"ours", "ours_kept"}) {
    targets.push_back({method + ", 100,000 points / 10,000 points", Wanted::kAtMost, 12,
                       growth(results, method)});
    targets.push_back({method + " / minmax, 100,000 points", Wanted::kAtMost, 3,
                       ratios(results, method, "minmax", many)});
  }
  return targets;
}

}  // namespace

Rows benchmarkObjects(bool quick) {
  const Results results = run(makeSuite(), quick ? 5 : 15, quick ? 0.01 : 0.05);
  const Rows rows = rowsPerPoint(results);
  printTable("ns per point",
             {{"type", "", 16}, {"points"}, {"ours"}, {"ours_kept"}, {"rescan"}, {"minmax"}},
             pivot(rows, {"type", "points"}, "method", "ns_per_point"));
  printTargets("", targets(results));
  return rows;
}

}  // namespace link_bounds::bench
