// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loaded as the node loads them.
#include "bench/volumes/volumes_robots.h"

#include "bench/common/robots.h"

namespace link_bounds::bench {
namespace {

/// Thinner links are left out: they have no volume to compare with.
constexpr double kThinnest = 1e-6;  // of the longest side

bool isFlat(const BoundedLink& link) {
  const std::optional<Aabb> box = linkBox(link, Eigen::Affine3d::Identity());
  return !box || box->sizes().minCoeff() <= kThinnest * box->sizes().maxCoeff();
}

MeasuredRobot readRobot(const RobotFile& file) {
  auto [robot, bounded] =
      loadRobot(textOf(file.urdf), {file.package_path, file.urdf.parent_path().string()});
  MeasuredRobot result{file.name(), std::move(robot), {}, {}};
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    if (!link.isWhole() || isFlat(link)) {
      std::cout << "left out, because it is flat or not whole: link " << link.name << " of "
                << result.name << "\n";
      continue;
    }
    result.links.push_back(link);
    result.index.push_back(bounded.indices[i]);
  }
  return result;
}

}  // namespace

std::vector<MeasuredRobot> chooseRobots() {
  std::vector<MeasuredRobot> result;
  for (const RobotFile& file : robots())
    result.push_back(readRobot(file));
  return result;
}

}  // namespace link_bounds::bench
