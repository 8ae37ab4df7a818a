// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A RobotLoader whose importer keeps each mesh.
#include "mesh_robot.h"

#include <filesystem>
#include <mutex>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/worker/mesh_process.h"
#include "testing/brute_force.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kMaxBytes = 1 << 20;  // of a file

Eigen::Affine3d scaledAndTurned() {
  return Eigen::Translation3d(0.1, 0, -0.2) * brute_force::turned(30, Eigen::Vector3d::UnitX()) *
         Eigen::Scaling(1.0, -2.0, 0.5);
}

Link meshLink(const std::string& file) {
  Element element;
  element.number = 1;
  element.mesh_uri = file;
  element.link_from_shape = scaledAndTurned();
  Link link;
  link.name = file;
  link.elements.push_back(element);
  return link;
}

}  // namespace

MeshRobot meshRobot(const std::string& folder, const std::vector<std::string>& files,
                    double timeout) {
  MeshRobot result;
  Robot robot;
  for (const std::string& file : files)
    robot.links.push_back(meshLink(file));
  const std::string worker = meshWorker();
  std::mutex mutex;
  RobotLoader loader([&](const MeshFile& file) {
    const std::string name = std::filesystem::path(file.path).filename();
    const double seconds = name == files.front() ? MeshLimits().timeout : timeout;
    TriangleMesh mesh = importInProcess(worker, file, {seconds, kMaxBytes});
    const std::lock_guard<std::mutex> lock(mutex);
    result.meshes[name] = mesh;
    return mesh;
  });
  result.links = loader.load(robot, Selection(), {nullptr, folder}).links;
  return result;
}

}  // namespace link_bounds
