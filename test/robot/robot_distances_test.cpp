// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances of the links of robots in random joint positions against a comparison of all their
// triangles in long double.
#include <gtest/gtest.h>

#include <iostream>

#include "link_bounds/geometry/distance/body_distances.h"
#include "link_bounds/robot/mesh/mesh_uri.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/worker/mesh_import.h"
#include "testing/distance_bodies.h"
#include "testing/robot_files.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

constexpr double kLimit = 0.15;                            // m
constexpr double kComparisons = kIsSanitized ? 3e5 : 3e7;  ///< of triangles, for each robot
constexpr double kLargestPair = kIsSanitized ? 2e5 : 2e7;
constexpr int kPoses = 50;

struct Model {
  Robot robot;
  std::vector<MeshBody> links;  ///< empty: a link without triangles, or with solids
};

/// Throws MeshError.
MeshBody linkOf(const Link& link, Purpose purpose, const PackagePath& package_path) {
  MeshBody result;
  for (const Element& element : link.elements) {
    if (element.purpose != purpose) continue;
    if (element.mesh_uri.empty()) return {};
    result.add(importMesh(resolveMeshUri(element.mesh_uri, package_path)), element.link_from_shape);
  }
  return result;
}

Model readModel(const RobotFile& file, Purpose purpose) {
  Model result{parseRobot(textOf(file.urdf)), {}};
  for (const Link& link : result.robot.links) {
    try {
      result.links.push_back(linkOf(link, purpose, file.package_path));
    } catch (const MeshError& error) {
      std::cout << "left out: link " << link.name << ": " << error.what() << "\n";
      result.links.emplace_back();
    }
  }
  return result;
}

std::vector<Eigen::Isometry3d> randomPoses(const Robot& robot, brute_force::Random& random) {
  std::map<std::string, double> values;
  for (const Joint& joint : robot.joints) {
    if (!hasValue(joint.motion) || joint.mimic) continue;
    const double largest = joint.motion == Motion::kRotation ? 2.5 : 0.1;
    values[joint.name] = random.uniform(-largest, largest);
  }
  return linkPoses(robot, jointValues(robot, values));
}

/// What was compared, by level.
struct Tally {
  double triangles = 0;
  std::map<DistanceLevel, int> pairs;
};

void comparePair(const MeshBody& a, const Eigen::Affine3d& pose, const MeshBody& b,
                 const Eigen::Affine3d& other, const BodyDistance& found, Tally& tally) {
  const auto first = a.placed(pose), second = b.placed(other);
  const auto exact = distance_oracle::distance(first, second, found.upper + 1e-6L);
  ASSERT_LE(found.lower, exact);
  ASSERT_GE(found.upper, exact);
  ASSERT_NEAR((found.on_second - found.on_first).norm(), found.upper, 1e-11);
  ASSERT_LE(distance_oracle::distance(found.on_first, first), 1e-9);
  ASSERT_LE(distance_oracle::distance(found.on_second, second), 1e-9);
  ASSERT_LE(found.upper - found.lower, 1e-4 + 1e-11);
  ++tally.pairs[found.level];
}

/// A warm start is part of the comparison.
void compareModel(const Model& model, Tally& tally) {
  brute_force::Random random(1);
  const RigidBodies rigid = rigidBodies(model.robot);
  BodyDistances distances({1e-4, kLimit});
  std::vector<double> counts;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    counts.push_back(0);
    for (const TriangleMesh& mesh : model.links[i].meshes)
      counts.back() += static_cast<double>(mesh.triangles.size());
    if (counts.back() > 0) distances.set(i, std::make_shared<Body>(model.links[i].body));
  }
  const double most = tally.triangles + kComparisons;
  for (int k = 0; k < kPoses && tally.triangles < most; ++k) {
    const auto poses = randomPoses(model.robot, random);
    for (std::size_t i = 0; i < poses.size(); ++i)
      distances.move(i, Eigen::Affine3d(poses[i]));
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (std::size_t j = i + 1; j < poses.size() && tally.triangles < most; ++j) {
        const double comparisons = counts[i] * counts[j];
        if (comparisons == 0 || comparisons > kLargestPair || areJoined(rigid, i, j)) continue;
        const BodyDistance found = distances.find(i, j).value();
        if (found.lower >= kLimit) continue;
        tally.triangles += comparisons;
        SCOPED_TRACE(model.robot.links[i].name + " and " + model.robot.links[j].name);
        comparePair(model.links[i], Eigen::Affine3d(poses[i]), model.links[j],
                    Eigen::Affine3d(poses[j]), found, tally);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

void compareRobot(const RobotFile& file) {
  for (const Purpose purpose : {Purpose::kCollision, Purpose::kVisual}) {
    const std::string name = file.name() + " " + toText(purpose);
    SCOPED_TRACE(name);
    Tally tally;
    compareModel(readModel(file, purpose), tally);
    std::cout << name << ": " << tally.pairs[DistanceLevel::kBox] << " pairs by boxes, "
              << tally.pairs[DistanceLevel::kHull] << " by hulls, "
              << tally.pairs[DistanceLevel::kMesh] << " by triangles; " << tally.triangles
              << " comparisons of triangles\n";
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(RobotDistances, OfTheDemoRobot) {
  compareRobot(demoRobotFile());
}

TEST(RobotDistances, OfPublicRobots) {
  const std::vector<RobotFile> files = publicRobotFiles();
  if (files.empty()) GTEST_SKIP() << "skipped: links of public robots: LINK_BOUNDS_DATA is not set";
  for (const RobotFile& file : files) {
    compareRobot(file);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace link_bounds
