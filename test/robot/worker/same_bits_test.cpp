// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes have the same bits on every machine, with every compiler and every path of instructions:
// those in data/boxes.txt, which were written on amd64. The poses are made of integers, because
// sines of one machine differ from those of another by the last bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "geometry/support/query/direction_query.h"
#include "link_bounds/geometry/shape/shape.h"
#include "robot/worker/mesh_import.h"

namespace link_bounds {
namespace {

using NamedShape = std::pair<std::string, Shape>;

const std::vector<std::string> kMeshes{"../launch/demo/meshes/finger_ascii.stl",
                                       "../launch/demo/meshes/forearm.obj",
                                       "../launch/demo/meshes/pedestal.stl",
                                       "../launch/demo/meshes/shoulder.dae",
                                       "../launch/demo/meshes/upper_arm_mm.stl",
                                       "../launch/demo/meshes/wrist.stl",
                                       "data/meshes/cube.stl",
                                       "data/meshes/plain.dae",
                                       "data/meshes/one_triangle.stl"};

NamedShape meshShape(const std::string& file) {
  const std::filesystem::path path = std::filesystem::canonical(file);
  const TriangleMesh mesh = importMesh({path, path.parent_path()});
  return {path.filename(), {std::make_shared<const PointSet>(mesh.vertices)}};
}

NamedShape solidShape(const std::string& name, Solid kind) {
  return {name, {nullptr, kind, {0.1, 0.2, 0.7}, Eigen::Affine3d::Identity()}};
}

std::vector<NamedShape> shapes() {
  std::vector<NamedShape> result;
  for (const std::string& file : kMeshes)
    result.push_back(meshShape(file));
  result.push_back(solidShape("box", Solid::kBox));
  result.push_back(solidShape("ellipsoid", Solid::kEllipsoid));
  result.push_back(solidShape("cylinder", Solid::kCylinder));
  return result;
}

/// The rotation of the quaternion w, x, y, z, which need not be of length 1.
Eigen::Affine3d turned(double w, double x, double y, double z, const Eigen::Vector3d& position) {
  Eigen::Matrix3d matrix;
  matrix << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),        //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  pose.linear() = matrix / (w * w + x * x + y * y + z * z);
  pose.translation() = position;
  return pose;
}

std::vector<Eigen::Affine3d> poses() {
  Eigen::Affine3d sheared = turned(3, 1, -2, 2, {-0.4, 0.5, 0.6});
  sheared.linear().row(1) += sheared.linear().row(2) / 3;
  sheared.linear().col(0) *= -0.001;
  return {Eigen::Affine3d::Identity(), turned(1, 1, 0, 0, {0.1, -0.2, 0.3}),
          turned(1, 2, 3, 4, {0.7, 0, -0.7}), turned(5, -1, 2, 1, {1000.1, -2000.2, 0.3}), sheared};
}

std::string lineOf(const std::string& name, std::size_t pose, const Aabb& box) {
  std::string line = name + " " + std::to_string(pose);
  for (const Eigen::Vector3d& corner : {box.min(), box.max()}) {
    for (int k = 0; k < 3; ++k) {
      char text[32];
      std::snprintf(text, sizeof text, " %a", corner[k]);
      line += text;
    }
  }
  return line + "\n";
}

std::string allLines() {
  std::string lines;
  const std::vector<Eigen::Affine3d> all_poses = poses();
  for (const auto& [name, shape] : shapes()) {
    for (std::size_t i = 0; i < all_poses.size(); ++i)
      lines += lineOf(name, i, worldBox(shape, all_poses[i]).value());
  }
  return lines;
}

TEST(SameBits, AsOnAmd64) {
  std::stringstream expected;
  expected << std::ifstream("data/boxes.txt").rdbuf();
  const QueryPath best = queryPath();
  for (const QueryPath path : kQueryPaths) {
    if (!isSupported(path)) continue;
    useQueryPath(path);
    EXPECT_EQ(allLines(), expected.str()) << "path " << static_cast<int>(path);
  }
  useQueryPath(best);
}

}  // namespace
}  // namespace link_bounds
