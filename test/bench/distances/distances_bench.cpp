// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times distances of robots' links, ours and others.
#include <cmath>
#include <set>

#include "bench/common/benchmarks.h"
#include "bench/distances/distance_report.h"
#include "geometry/distance/triangle_tree.h"

namespace link_bounds::bench {
namespace {

/// A peer that is not installed is not compiled.
std::vector<DistanceSetting> distanceSettings() {
  std::vector<DistanceSetting> settings;
  addOurDistances(settings);
#ifdef LINK_BOUNDS_WITH_FCL
  addFclDistances(settings);
#endif
#ifdef LINK_BOUNDS_WITH_BULLET
  addBulletDistances(settings);
#endif
  return settings;
}

/// Of the trees of all links, each counted once; not a number without triangles.
double bytesPerTriangle(const DistanceRobot& robot) {
  std::set<std::shared_ptr<const TriangleTree>> trees;
  double sum = 0, triangles = 0;
  for (const DistanceLink& link : robot.links) {
    for (const BodyShape& shape : link.body.shapes) {
      if (!shape.triangles || !trees.insert(shape.triangles).second) continue;
      sum += static_cast<double>(bytes(*shape.triangles));
      triangles += static_cast<double>(shape.triangles->triangles.size());
    }
  }
  return sum / triangles;
}

}  // namespace

Rows benchmarkDistances(bool quick) {
  const std::vector<DistanceSetting> settings = distanceSettings();
  const Table table = distanceTable();
  Rows rows;
  std::vector<double> bytes_per_triangle;
  const auto add = [&](const DistanceRows& more) {
    for (const DistanceRow& row : more)
      table.add(rows.emplace_back(rowOf(row)));
  };
  for (const DistanceRobot& robot : distanceRobots(quick ? 5 : 50)) {
    add(measurePairs(robot, settings));
    add(measureUpdates(robot));
    const double bytes = bytesPerTriangle(robot);
    if (!std::isnan(bytes)) bytes_per_triangle.push_back(bytes);
  }
  add(measureGrowth(settings, quick));
  printDistanceTargets(rows, bytes_per_triangle);
  return rows;
}

}  // namespace link_bounds::bench
