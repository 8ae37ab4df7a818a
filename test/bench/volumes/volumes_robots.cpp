// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loaded as the node loads them.
#include "bench/volumes/volumes_robots.h"

#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "testing/robot_files.h"

namespace link_bounds::bench {
namespace {

namespace fs = std::filesystem;

/// Thinner links are left out: they have no volume to compare with.
constexpr double kThinnest = 1e-6;  // of the longest side

bool isFlat(const BoundedLink& link) {
  const std::optional<Aabb> box = linkBox(link, Eigen::Affine3d::Identity());
  return !box || box->sizes().minCoeff() <= kThinnest * box->sizes().maxCoeff();
}

MeasuredRobot readRobot(const fs::path& urdf, const PackagePath& package_path,
                        std::ostream& notes) {
  std::ostringstream text;
  text << std::ifstream(urdf).rdbuf();
  auto [robot, bounded] = loadRobot(text.str(), {package_path, urdf.parent_path().string()});
  MeasuredRobot result{urdf.stem().string(), std::move(robot), {}, {}};
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    if (!link.isWhole() || isFlat(link)) {
      notes << "left out, because it is flat or not whole: link " << link.name << " of "
            << result.name << "\n";
      continue;
    }
    result.links.push_back(link);
    result.index.push_back(bounded.indices[i]);
  }
  return result;
}

}  // namespace

std::vector<MeasuredRobot> chooseRobots(const std::string& data_folder,
                                        const std::string& demo_urdf, std::ostream& notes) {
  const fs::path demo = fs::canonical(demo_urdf);
  if (data_folder.empty()) {
    notes << "LINK_BOUNDS_DATA is not set: the demo's robot stands in for public ones\n";
    const fs::path package = demo.parent_path().parent_path().parent_path();
    return {readRobot(
        demo, [&package](const std::string&) { return package.string(); }, notes)};
  }
  const fs::path folder = fs::canonical(fs::path(data_folder) / "robots");
  std::vector<MeasuredRobot> result;
  for (const fs::path& path : robotFiles(folder)) {
    const auto package_path = [&folder](const std::string& name) {
      return (folder / name).string();
    };
    result.push_back(readRobot(path, package_path, notes));
  }
  return result;
}

}  // namespace link_bounds::bench
