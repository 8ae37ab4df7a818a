// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What another package may do with the library: from a URDF and joint values to a message of boxes.
//
// usage: link_bounds_consumer URDF PACKAGES JOINT VALUE, where PACKAGES is a folder of packages
#include <link_bounds/AxisAlignedBoxArray.h>
#include <link_bounds/robot/bounded_robot.h>
#include <link_bounds/robot/urdf/kinematics.h>
#include <link_bounds/robot/worker/mesh_process.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

using link_bounds::AxisAlignedBox;
using link_bounds::AxisAlignedBoxArray;

link_bounds::Robot readRobot(const char* file) {
  std::ifstream in(file);
  return link_bounds::parseRobot({std::istreambuf_iterator<char>(in), {}});
}

/// The links that have geometry, with all their meshes.
link_bounds::BoundedRobot boundRobot(const link_bounds::Robot& robot, const std::string& packages) {
  const std::string worker = link_bounds::meshWorker();
  link_bounds::MeshStore store([&worker](const link_bounds::MeshFile& file) {
    return link_bounds::importInProcess(worker, file, link_bounds::MeshLimits());
  });
  link_bounds::MeshSource source;
  source.package_path = [&packages](const std::string& name) { return packages + "/" + name; };
  return link_bounds::boundRobot(robot, link_bounds::Selection(), source, store);
}

AxisAlignedBox toMessage(const std::string& name, const link_bounds::Aabb& box) {
  AxisAlignedBox message;
  message.name = name;
  message.min.x = box.min().x();
  message.min.y = box.min().y();
  message.min.z = box.min().z();
  message.max.x = box.max().x();
  message.max.y = box.max().y();
  message.max.z = box.max().z();
  return message;
}

/// In the frame of the root link, those of links in the order of the URDF.
AxisAlignedBoxArray boxesOf(const link_bounds::Robot& robot,
                            const link_bounds::BoundedRobot& bounded,
                            const std::map<std::string, double>& joints) {
  const auto poses = linkPoses(robot, jointValues(robot, joints));
  AxisAlignedBoxArray result;
  result.header.frame_id = robot.links[robot.root].name;
  for (const link_bounds::BoundedLink& link : bounded.links) {
    std::size_t i = 0;
    while (robot.links[i].name != link.name)
      ++i;
    const auto box = linkBox(link, Eigen::Affine3d(poses[i]));
    if (box) result.boxes.push_back(toMessage(link.name, *box));
    if (!link.isWhole() || !box) result.incomplete.push_back(link.name);
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const link_bounds::Robot robot = readRobot(argv[1]);
  const link_bounds::BoundedRobot bounded = boundRobot(robot, argv[2]);
  for (const std::string& problem : bounded.problems)
    std::fprintf(stderr, "%s\n", problem.c_str());
  const AxisAlignedBoxArray boxes = boxesOf(robot, bounded, {{argv[3], std::atof(argv[4])}});
  for (const AxisAlignedBox& box : boxes.boxes)
    std::printf("%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", box.name.c_str(), box.min.x, box.min.y,
                box.min.z, box.max.x, box.max.y, box.max.z);
  return boxes.incomplete.empty() ? 0 : 1;
}
