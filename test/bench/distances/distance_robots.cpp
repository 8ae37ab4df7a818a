// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads robots with the triangles of their meshes, and moves their joints.
#include "bench/distances/distance_robots.h"

#include <cmath>
#include <iostream>

#include "bench/common/robots.h"
#include "link_bounds/robot/mesh/mesh_uri.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/worker/mesh_import.h"
#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr double kRotation = 2.5;     ///< joints stay within plus and minus this [rad]
constexpr double kTranslation = 0.1;  ///< [m]
constexpr double kSmallStep = 0.01;   ///< of a coherent motion [rad], at most

struct LoadedFile {
  TriangleMesh mesh;
  std::shared_ptr<const PointSet> points;
  std::shared_ptr<const TriangleTree> tree;
};

using Files = std::map<std::string, LoadedFile>;

const LoadedFile& loaded(const MeshFile& file, Files& files) {
  const auto [entry, is_new] = files.try_emplace(file.path);
  LoadedFile& result = entry->second;
  if (!is_new) return result;
  result.mesh = importMesh(file);
  result.points = std::make_shared<const PointSet>(result.mesh.vertices);
  result.tree = triangleTree(result.mesh);
  return result;
}

void append(const TriangleMesh& mesh, const Eigen::Affine3d& link_from_mesh, TriangleMesh& all) {
  const auto first = static_cast<std::uint32_t>(all.vertices.size());
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    all.vertices.push_back((link_from_mesh * vertex.cast<double>()).cast<float>());
  for (const auto& [a, b, c] : mesh.triangles)
    all.triangles.push_back({first + a, first + b, first + c});
}

/// Throws MeshError.
DistanceLink linkOf(const Link& link, Purpose purpose, const PackagePath& package_path,
                    Files& files) {
  DistanceLink result;
  bool has_solid = false;
  for (const Element& element : link.elements) {
    if (element.purpose != purpose) continue;
    BodyShape shape{{nullptr, element.solid, element.size, element.link_from_shape}, nullptr};
    if (element.mesh_uri.empty()) {
      has_solid = true;
    } else {
      const LoadedFile& file = loaded(resolveMeshUri(element.mesh_uri, package_path), files);
      shape.shape.points = file.points;
      shape.triangles = file.tree;
      append(file.mesh, element.link_from_shape, result.mesh);
    }
    result.body.shapes.push_back(shape);
  }
  if (has_solid) result.mesh = {};
  return result;
}

double amplitude(const Joint& joint) {
  return joint.motion == Motion::kRotation ? kRotation : kTranslation;
}

/// Random values, or a sine of random phase for each joint.
std::vector<LinkPoses> motionOf(const Robot& robot, const std::vector<std::size_t>& indices,
                                std::size_t steps, bool is_coherent) {
  brute_force::Random random(1);
  std::vector<double> phases;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    phases.push_back(random.uniform(0, 2 * M_PI));
  std::vector<LinkPoses> result;
  for (std::size_t step = 0; step < steps; ++step) {
    std::map<std::string, double> values;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const Joint& joint = robot.joints[i];
      if (!hasValue(joint.motion) || joint.mimic) continue;
      const double angle = phases[i] + kSmallStep / kRotation * static_cast<double>(step);
      const double share = is_coherent ? std::sin(angle) : random.uniform(-1, 1);
      values[joint.name] = amplitude(joint) * share;
    }
    const auto poses = linkPoses(robot, jointValues(robot, values));
    LinkPoses chosen;
    for (const std::size_t index : indices)
      chosen.emplace_back(poses[index]);
    result.push_back(chosen);
  }
  return result;
}

DistanceRobot readRobot(const RobotFile& file, Purpose purpose, std::size_t steps) {
  const Robot robot = parseRobot(textOf(file.urdf));
  DistanceRobot result{file.name() + " " + toText(purpose), {}, {}, {}, steps};
  Files files;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    try {
      DistanceLink link = linkOf(robot.links[i], purpose, file.package_path, files);
      if (link.body.shapes.empty()) continue;
      result.links.push_back(std::move(link));
      indices.push_back(i);
    } catch (const MeshError& error) {
      std::cout << "left out: link " << robot.links[i].name << " of " << result.name << ": "
                << error.what() << "\n";
    }
  }
  for (const auto& [path, loaded] : files)
    result.triangles += loaded.mesh.triangles.size();
  const RigidBodies bodies = rigidBodies(robot);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    for (std::size_t j = i + 1; j < indices.size(); ++j) {
      if (!areJoined(bodies, indices[i], indices[j])) result.pairs.emplace_back(i, j);
    }
  }
  result.motions["random"] = motionOf(robot, indices, 12 * steps, false);
  result.motions["coherent"] = motionOf(robot, indices, 12 * steps, true);
  return result;
}

}  // namespace

std::vector<DistanceRobot> distanceRobots(std::size_t steps) {
  std::vector<DistanceRobot> result;
  for (const RobotFile& file : robots()) {
    for (const Purpose purpose : {Purpose::kCollision, Purpose::kVisual}) {
      DistanceRobot robot = readRobot(file, purpose, steps);
      if (!robot.pairs.empty()) result.push_back(std::move(robot));
    }
  }
  return result;
}

}  // namespace link_bounds::bench
