// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two ellipsoids, all of whose vertices are extreme, that pass each other.
#include <cmath>

#include "bench/distances/distance_measure.h"
#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

/// Closed, of about `count` triangles.
TriangleMesh ellipsoid(std::size_t count) {
  const auto rows =
      static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(count) / 4)));
  const std::uint32_t columns = 2 * rows;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double down = M_PI * i / rows, around = 2 * M_PI * j / columns;
      const Eigen::Vector3d unit(std::sin(down) * std::cos(around),
                                 std::sin(down) * std::sin(around), std::cos(down));
      mesh.vertices.push_back(unit.cwiseProduct(Eigen::Vector3d(0.1, 0.15, 0.3)).cast<float>());
      if (i == rows) continue;
      const std::uint32_t here = i * columns + j, next = i * columns + (j + 1) % columns;
      mesh.triangles.push_back({here, here + columns, next});
      mesh.triangles.push_back({next, here + columns, next + columns});
    }
  }
  return mesh;
}

std::vector<LinkPoses> motionOf(bool is_coherent, std::size_t steps) {
  brute_force::Random random(1);
  Eigen::Affine3d first = random.rigid(0), second = random.rigid(0);
  first.translation().setZero();
  std::vector<LinkPoses> result;
  for (std::size_t i = 0; i < steps; ++i) {
    if (is_coherent) {
      second.rotate(Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 2, 3).normalized()));
    } else {
      first = random.rigid(0);
      first.translation().setZero();
      second = random.rigid(0);
    }
    second.translation() = Eigen::Vector3d(0.62, 0.01 * std::sin(0.01 * static_cast<double>(i)), 0);
    result.push_back({first, second});
  }
  return result;
}

DistanceRobot bodiesOf(std::size_t triangles, std::size_t steps) {
  const TriangleMesh mesh = ellipsoid(triangles);
  const Shape shape{std::make_shared<const PointSet>(mesh.vertices)};
  DistanceRobot result{"ellipsoids", {}, {{0, 1}}, {}, steps};
  for (int i = 0; i < 2; ++i)
    result.links.push_back({{{{shape, triangleTree(mesh)}}}, mesh});
  result.motions["random"] = motionOf(false, steps + 1);
  result.motions["coherent"] = motionOf(true, steps + 1);
  return result;
}

}  // namespace

DistanceRows measureGrowth(const std::vector<DistanceSetting>& settings, bool quick) {
  std::vector<DistanceSetting> hulls;
  for (const DistanceSetting& setting : settings) {
    if (setting.level == "hull") hulls.push_back(setting);
  }
  DistanceRows result;
  for (const std::size_t triangles : {1000u, 10000u, 50000u, 200000u}) {
    const DistanceRobot bodies = bodiesOf(triangles, quick ? 500 : 2000);
    for (DistanceRow& row : measurePairs(bodies, hulls)) {
      if (row.which != "all") continue;
      row.which = "generated";
      row.triangles = triangles;
      result.push_back(std::move(row));
    }
  }
  return result;
}

}  // namespace link_bounds::bench
