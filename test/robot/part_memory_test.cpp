// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a link, and the tree of a mesh, where memory runs out while they are made.
#include <gtest/gtest.h>

#include "link_bounds/robot/robot_loader.h"
#include "testing/part_meshes.h"
#include "testing/replaced_new.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

/// The points of each shape of a part.
std::vector<std::size_t> pointsOf(const BoundedLink& part) {
  std::vector<std::size_t> result;
  for (const Shape& shape : part.shapes)
    result.push_back(shape.points ? shape.points->size() : 0);
  return result;
}

class PartMemory : public testing::Test {
 protected:
  PartMemory() {
    folder_.write("good.stl");
    folder_.write("bad.stl");
  }

  ~PartMemory() override { replaced_new::limit = replaced_new::kNoLimit; }

  /// One link with the given meshes. Memory runs out when they are loaded.
  BoundedRobot bound(const std::vector<std::string>& files) {
    std::string visuals;
    for (const std::string& file : files) {
      visuals += "<visual><origin xyz='7 0 0'/><geometry><mesh filename='" + file +
                 "'/></geometry></visual>";
    }
    const Robot robot = parseRobot("<robot name='r'><link name='l'>" + visuals + "</link></robot>");
    RobotLoader loader([](const MeshFile& file) -> TriangleMesh {
      if (file.path.find("bad") != std::string::npos) throw std::bad_alloc();
      return hook(60, 40);
    });
    const auto end_memory = [](std::size_t done, std::size_t total) {
      if (done == total) replaced_new::limit = 50'000;
    };
    Selection selection;
    selection.parts_per_link = 8;
    const BoundedRobot bounded =
        loader.load(robot, selection, {nullptr, folder_.path().string(), end_memory});
    replaced_new::limit = replaced_new::kNoLimit;
    return bounded;
  }

  TemporaryFolder folder_;
};

TEST_F(PartMemory, ALinkThatCannotBeSplitIsItsOnlyPart) {
  const BoundedRobot robot = bound({"good.stl"});
  ASSERT_EQ(robot.parts.size(), 1u);
  ASSERT_EQ(robot.parts[0].size(), 1u);
  EXPECT_EQ(pointsOf(robot.parts[0][0]), pointsOf(robot.links[0]));
}

TEST_F(PartMemory, AMeshThatFailedIsInNoPart) {
  const BoundedRobot robot = bound({"bad.stl", "good.stl", "bad.stl"});
  ASSERT_EQ(robot.links.size(), 1u);
  EXPECT_EQ(robot.links[0].shapes.size(), 1u);
  ASSERT_EQ(robot.parts.size(), 1u);
  ASSERT_EQ(robot.parts[0].size(), 1u);
  EXPECT_EQ(pointsOf(robot.parts[0][0]), pointsOf(robot.links[0]));
  const Eigen::Affine3d identity = Eigen::Affine3d::Identity();
  const Aabb part = linkBox(robot.parts[0][0], identity).value();
  const Aabb link = linkBox(robot.links[0], identity).value();
  EXPECT_EQ(part.min(), link.min());
  EXPECT_EQ(part.max(), link.max());
}

TEST_F(PartMemory, ATreeThatDoesNotFitLeavesThePoints) {
  bool ends = false;
  RobotLoader loader([&](const MeshFile&) {
    TriangleMesh mesh = hook(60, 40);
    if (ends) replaced_new::limit = 50'000;
    return mesh;
  });
  const MeshSource source{nullptr, folder_.path().string()};
  const auto mesh = loader.loadMeshes({"good.stl"}, source);
  ASSERT_TRUE(mesh.at(0).points);
  ends = true;
  const auto tree = loader.loadTrees({"good.stl"}, source);
  replaced_new::limit = replaced_new::kNoLimit;
  EXPECT_FALSE(tree.at(0).triangles);
  EXPECT_EQ(tree[0].points, mesh[0].points);
  EXPECT_NE(tree[0].error.find("its triangles do not fit into memory"), std::string::npos);
}

}  // namespace
}  // namespace link_bounds
