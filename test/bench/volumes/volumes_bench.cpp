// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How tight volumes are and what they cost.
#include <cmath>

#include "bench/common/benchmarks.h"
#include "bench/common/table.h"
#include "bench/volumes/volumes_measure.h"

namespace link_bounds::bench {
namespace {

/// Thinner links are left out: they have no volume to compare with.
constexpr double kThinnest = 1e-6;  // of the longest side

std::string whyLeftOut(const BoundedLink& link) {
  const std::optional<Aabb> box = linkBox(link, Eigen::Affine3d::Identity());
  const bool is_flat = !box || box->sizes().minCoeff() <= kThinnest * box->sizes().maxCoeff();
  return link.isWhole() && is_flat ? "it is flat" : link.missing;
}

using Value = double Result::*;

/// The mean of a column over the links of all robots, or of one.
double mean(const Results& results, const std::string& method, Value value,
            const std::string& robot = "") {
  double sum = 0;
  double links = 0;
  for (const Result& result : results) {
    const bool is_meant = result.method == method && (robot.empty() || result.mesh == robot);
    if (!is_meant || std::isnan(result.*value)) continue;
    sum += result.*value * static_cast<double>(result.vertices);
    links += static_cast<double>(result.vertices);
  }
  return sum / links;
}

Row rowOf(const Results& results, const MeasuredRobot& robot) {
  Row row{{"robot", robot.name}, {"links", robot.links.size()}};
  for (const char* method : {kAabb, kAabbAtJoints, kSphere, kOrientedBox})
    row.emplace_back(method, mean(results, method, &Result::volume_ratio, robot.name));
  return row;
}

Row rowOf(const Results& results, const char* name, const char* method, const char* once,
          const char* overlap) {
  return {{"bounded by", name},
          {"volume", mean(results, method, &Result::volume_ratio)},
          {"ns per update", mean(results, method, &Result::ns)},
          {"ms once, beside the table", mean(results, once, &Result::ns) / 1e6},
          {"ns per overlap test", mean(results, overlap, &Result::ns)}};
}

void print(const Results& results, const std::vector<MeasuredRobot>& robots) {
  const Table volumes(
      "Mean volume, divided by that of the axis-aligned box of the same link turned at random",
      {{"robot", "", 20},
       {"links"},
       {kAabb, "box, turned at random"},
       {kAabbAtJoints, "box, joints at random"},
       {kSphere},
       {kOrientedBox, "oriented box"}});
  for (const MeasuredRobot& robot : robots)
    volumes.add(rowOf(results, robot));
  printTable("Means over all links; -: not measured",
             {{"bounded by", "", 36},
              {"volume"},
              {"ns per update"},
              {"ms once, beside the table"},
              {"ns per overlap test"}},
             {rowOf(results, "axis-aligned box", kAabb, "", kOverlapAabb),
              rowOf(results, "axis-aligned box, joints at random", kAabbAtJoints, "", ""),
              rowOf(results, "sphere", kSphere, kPrepareSphere, kOverlapSphere),
              rowOf(results, "oriented box", kOrientedBox, kPrepareOrientedBox, "")});
}

}  // namespace

Rows benchmarkVolumes(bool quick) {
  std::vector<MeasuredRobot> measured;
  for (const RobotFile& file : robots())
    measured.push_back(measuredRobot(file, {}, whyLeftOut));
  const Results results = measureVolumes(measured, quick);
  print(results, measured);
  return rowsOf(results);
}

}  // namespace link_bounds::bench
