// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads robots with the triangles of their meshes, and moves their joints.
#include "bench/distances/distance_robots.h"

#include <cmath>

#include "bench/common/robots.h"
#include "geometry/distance/triangle_tree.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr double kRotation = 2.5;     ///< joints stay within plus and minus this [rad]
constexpr double kTranslation = 0.1;  ///< [m]
constexpr double kSmallStep = 0.01;   ///< of a coherent motion [rad], at most

/// Empty if a shape is a solid.
TriangleMesh meshOf(const Body& body) {
  TriangleMesh mesh;
  for (const BodyShape& shape : body.shapes) {
    if (!shape.triangles) return {};
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : shape.triangles->vertices)
      mesh.vertices.push_back((shape.shape.link_from_shape * vertex).cast<float>());
    for (const auto& [i, j, k] : shape.triangles->triangles)
      mesh.triangles.push_back({first + i, first + j, first + k});
  }
  return mesh;
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
  Selection selection;
  selection.visual = purpose == Purpose::kVisual;
  selection.collision = !selection.visual;
  selection.triangles = true;
  const MeasuredRobot loaded = measuredRobot(file, selection);
  const std::vector<std::size_t>& indices = loaded.indices;
  DistanceRobot result{loaded.name + " " + toText(purpose), {}, {}, {}, steps};
  for (const Body& body : loaded.bodies)
    result.links.push_back({body, meshOf(body)});
  const RigidBodies bodies = rigidBodies(loaded.robot);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    for (std::size_t j = i + 1; j < indices.size(); ++j) {
      if (!areJoined(bodies, indices[i], indices[j])) result.pairs.emplace_back(i, j);
    }
  }
  result.motions["random"] = motionOf(loaded.robot, indices, 12 * steps, false);
  result.motions["coherent"] = motionOf(loaded.robot, indices, 12 * steps, true);
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
