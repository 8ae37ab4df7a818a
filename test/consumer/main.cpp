// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What another package may do with the library: from a URDF and joint values to a message of boxes,
// and to the distances of near links.
//
// usage: link_bounds_consumer URDF PACKAGES JOINT VALUE, where PACKAGES is a folder of packages
#include <link_bounds/AxisAlignedBoxArray.h>
#include <link_bounds/geometry/distance/body_distance.h>
#include <link_bounds/robot/robot_loader.h>
#include <link_bounds/robot/urdf/kinematics.h>
#include <link_bounds/robot/urdf/overlap_filter.h>
#include <link_bounds/ros/messages.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

using link_bounds::AxisAlignedBox;
using link_bounds::AxisAlignedBoxArray;

/// In the frame of the root link, in the order of the URDF.
AxisAlignedBoxArray boxesOf(const link_bounds::LoadedRobot& loaded,
                            const std::map<std::string, double>& joints) {
  const auto& [robot, bounded] = loaded;
  const auto poses = linkPoses(robot, jointValues(robot, joints));
  AxisAlignedBoxArray result;
  result.header.frame_id = robot.links[robot.root].name;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const link_bounds::BoundedLink& link = bounded.links[i];
    const auto box = linkBox(link, Eigen::Affine3d(poses[bounded.indices[i]]));
    if (box) result.boxes.push_back(link_bounds::toMessage(link.name, *box));
    if (!link.isWhole() || !box) result.incomplete.push_back(link.name);
  }
  return result;
}

void printDistances(const link_bounds::LoadedRobot& loaded,
                    const std::map<std::string, double>& joints) {
  const auto& [robot, bounded] = loaded;
  const auto poses = linkPoses(robot, jointValues(robot, joints));
  const link_bounds::RigidBodies rigid = rigidBodies(robot);
  link_bounds::DistanceGoal goal;
  goal.limit = 0.1;  // pairs farther apart need no accuracy [m]
  for (std::size_t i = 0; i < bounded.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bounded.bodies.size(); ++j) {
      const std::size_t first = bounded.indices[i];
      const std::size_t second = bounded.indices[j];
      if (areJoined(rigid, first, second)) continue;
      const auto found =
          link_bounds::bodyDistance(bounded.bodies[i], Eigen::Affine3d(poses[first]),
                                    bounded.bodies[j], Eigen::Affine3d(poses[second]), goal);
      if (found && found->lower <= goal.limit)
        std::printf("%s,%s,%.17g,%.17g\n", bounded.links[i].name.c_str(),
                    bounded.links[j].name.c_str(), found->lower, found->upper);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  std::ifstream file(argv[1]);
  const std::string urdf(std::istreambuf_iterator<char>(file), {});
  const auto folder_of = [&](const std::string& package) { return argv[2] + ("/" + package); };
  link_bounds::Selection selection;
  selection.triangles = true;
  const link_bounds::LoadedRobot loaded = link_bounds::loadRobot(urdf, {folder_of}, selection);
  for (const std::string& problem : loaded.bounded.problems)
    std::fprintf(stderr, "%s\n", problem.c_str());
  const AxisAlignedBoxArray boxes = boxesOf(loaded, {{argv[3], std::atof(argv[4])}});
  for (const AxisAlignedBox& box : boxes.boxes)
    std::printf("%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", box.name.c_str(), box.min.x, box.min.y,
                box.min.z, box.max.x, box.max.y, box.max.z);
  printDistances(loaded, {{argv[3], std::atof(argv[4])}});
  return boxes.incomplete.empty() ? 0 : 1;
}
