// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Links with the triangles of their meshes, and meshes whose triangles are loaded later.
#include <gtest/gtest.h>

#include <atomic>

#include "link_bounds/geometry/distance/body_distance.h"
#include "link_bounds/robot/robot_loader.h"
#include "testing/part_meshes.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

std::string meshVisual(const std::string& file, const std::string& scale = "1 1 1") {
  return "<visual><geometry><mesh filename='" + file + "' scale='" + scale +
         "'/></geometry></visual>";
}

const std::string kBallVisual = "<visual><geometry><sphere radius='1'/></geometry></visual>";

std::string link(const std::string& name, const std::string& visuals) {
  return "<link name='" + name + "'>" + visuals + "</link>";
}

std::string remedy(MeshFault fault) {
  return fault == MeshFault::kTooLarge ? "allow more" : plainRemedy(fault);
}

/// The text of a file is the radius of a ball, or the name of another mesh.
TriangleMesh read(const MeshFile& file) {
  std::string text;
  if (!(std::ifstream(file.path) >> text)) throw MeshError("it is empty");
  if (text == "hook") return hook(60, 40);
  if (text == "far") return {{{0, 0, 0}, {1e35f, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  TriangleMesh mesh = ball(8, 12);
  for (Eigen::Vector3f& vertex : mesh.vertices)
    vertex *= std::stof(text);
  return mesh;
}

class RobotBodies : public testing::Test {
 protected:
  BoundedRobot bound(const std::string& links, Selection selection = withTriangles()) {
    std::string text = "<robot name='r'>" + links;
    for (const char* child : {"b", "c"}) {
      if (links.find(std::string("name='") + child + "'") == std::string::npos) continue;
      text += std::string("<joint name='to_") + child +
              "' type='fixed'><parent link='a'/><child link='" + child + "'/></joint>";
    }
    return loader_.load(parseRobot(text + "</robot>"), selection, source());
  }

  static Selection withTriangles() {
    Selection selection;
    selection.triangles = true;
    return selection;
  }

  MeshSource source() const { return {nullptr, folder_.path().string(), nullptr, limits_}; }

  TemporaryFolder folder_;
  MeshLimits limits_;
  std::atomic<int> imports_{0};
  RobotLoader loader_{[this](const MeshFile& file) {
                        ++imports_;
                        return read(file);
                      },
                      remedy};
};

TEST_F(RobotBodies, AreThereOnlyWhereTheyAreSelected) {
  folder_.write("ball", "1");
  const BoundedRobot robot = bound(link("a", meshVisual("ball")), {});
  EXPECT_TRUE(robot.bodies.empty());
  EXPECT_TRUE(robot.body_problems.empty());
}

TEST_F(RobotBodies, HaveTheShapesOfTheirLinksAndOneTreePerFile) {
  folder_.write("ball", "1");
  folder_.write("other", "2");
  const BoundedRobot robot =
      bound(link("a", meshVisual("ball") + kBallVisual + meshVisual("missing")) +
            link("b", meshVisual("missing") + meshVisual("other")) +
            link("c", meshVisual("./ball", "-0.001 0.001 0.001")));
  EXPECT_EQ(imports_, 2);
  EXPECT_EQ(robot.problems.size(), 2u);
  EXPECT_TRUE(robot.body_problems.empty());
  ASSERT_EQ(robot.bodies.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(robot.bodies[i].shapes.size(), robot.links[i].shapes.size());
    for (std::size_t j = 0; j < robot.bodies[i].shapes.size(); ++j) {
      const BodyShape& shape = robot.bodies[i].shapes[j];
      EXPECT_EQ(shape.shape.points, robot.links[i].shapes[j].points);
      EXPECT_EQ(shape.shape.solid, robot.links[i].shapes[j].solid);
      EXPECT_EQ(shape.shape.link_from_shape.matrix(),
                robot.links[i].shapes[j].link_from_shape.matrix());
      EXPECT_EQ(shape.triangles != nullptr, shape.shape.points != nullptr);
    }
  }
  EXPECT_EQ(robot.bodies[0].shapes[0].triangles, robot.bodies[2].shapes[0].triangles);
  EXPECT_NE(robot.bodies[0].shapes[0].triangles, robot.bodies[1].shapes[0].triangles);
}

TEST_F(RobotBodies, GiveTheDistanceOfTheMeshesAsTheirLinksPlaceThem) {
  folder_.write("ball", "1");
  const BoundedRobot robot =
      bound(link("a", meshVisual("ball")) + link("b", meshVisual("ball", "1 1 -0.5")));
  ASSERT_EQ(robot.bodies.size(), 2u);
  const Eigen::Affine3d above(Eigen::Translation3d(0, 0, 4));
  const auto distance =
      bodyDistance(robot.bodies[0], Eigen::Affine3d::Identity(), robot.bodies[1], above);
  ASSERT_TRUE(distance);
  EXPECT_NEAR(distance->lower, 2.5, 1e-4);
  EXPECT_NEAR(distance->upper, 2.5, 1e-4);
}

TEST_F(RobotBodies, AndPartsAreMadeOfOneReading) {
  folder_.write("hook", "hook");
  Selection selection;
  selection.parts_per_link = 8;
  const BoundedRobot parts = bound(link("a", meshVisual("hook")), selection);
  EXPECT_EQ(imports_, 1);
  selection.triangles = true;
  const BoundedRobot both = bound(link("a", meshVisual("hook")), selection);
  EXPECT_EQ(imports_, 2);
  ASSERT_EQ(both.bodies.size(), 1u);
  EXPECT_TRUE(both.bodies[0].shapes.at(0).triangles);
  ASSERT_EQ(both.parts.at(0).size(), parts.parts.at(0).size());
  EXPECT_GT(both.parts[0].size(), 1u);
}

TEST_F(RobotBodies, OfMeshesThatAreTooLargeHaveNoTriangles) {
  const std::string path = folder_.write("ball", "1");
  limits_.max_bytes = maxTreeBytes(read({path, ""}));
  EXPECT_TRUE(bound(link("a", meshVisual("ball"))).body_problems.empty());
  --limits_.max_bytes;
  const BoundedRobot robot = bound(link("a", kBallVisual + meshVisual("ball")));
  EXPECT_TRUE(robot.problems.empty());
  EXPECT_TRUE(robot.links.at(0).isWhole());
  ASSERT_EQ(robot.bodies.size(), 1u);
  EXPECT_TRUE(robot.bodies[0].shapes.at(1).shape.points);
  EXPECT_FALSE(robot.bodies[0].shapes[1].triangles);
  const std::string needed = std::to_string(limits_.max_bytes + 1);
  EXPECT_EQ(robot.body_problems,
            std::vector<std::string>{"link \"a\", visual 2 (ball): distances are those of the "
                                     "convex hull of " +
                                     path + ": its 192 triangles could take " + needed +
                                     " bytes of memory, which are more than the " +
                                     std::to_string(limits_.max_bytes) + " allowed; allow more"});
}

TEST_F(RobotBodies, WithoutTrianglesSayWhy) {
  folder_.write("far", "far");
  const BoundedRobot robot = bound(link("a", meshVisual("far")));
  ASSERT_EQ(robot.body_problems.size(), 1u);
  EXPECT_NE(robot.body_problems[0].find("a coordinate exceeds 1e30 m; repair or replace the file"),
            std::string::npos);
  EXPECT_FALSE(robot.bodies.at(0).shapes.at(0).triangles);
}

TEST_F(RobotBodies, MeshesInUseAreKnownByTheirUris) {
  const std::string ball = folder_.write("ball", "1");
  const BoundedRobot robot = bound(link("a", meshVisual("ball") + meshVisual("missing")) +
                                   link("b", meshVisual("file://" + ball)));
  ASSERT_EQ(robot.mesh_uris.size(), 2u);
  EXPECT_EQ(robot.mesh_uris.at("ball"), robot.links.at(0).shapes.at(0).points);
  EXPECT_EQ(robot.mesh_uris.at("file://" + ball), robot.links.at(0).shapes.at(0).points);
}

TEST_F(RobotBodies, TreesOfMeshesInUseCanBeLoadedLater) {
  const std::string ball = folder_.write("ball", "1");
  const std::string other = folder_.write("other", "2");
  const BoundedRobot robot = bound(link("a", meshVisual("ball") + meshVisual("other")), {});
  imports_ = 0;
  const auto trees =
      loader_.loadTrees({"other", "missing", "ball", "file://" + ball, "package://x/y"}, source());
  EXPECT_EQ(imports_, 2) << "equal paths are read once";
  ASSERT_EQ(trees.size(), 5u);
  for (const std::size_t i : {0u, 2u, 3u}) {
    ASSERT_TRUE(trees[i].triangles) << trees[i].error;
    EXPECT_EQ(trees[i].error, "");
  }
  EXPECT_EQ(trees[0].points, robot.mesh_uris.at("other"));
  EXPECT_EQ(trees[2].points, robot.mesh_uris.at("ball"));
  EXPECT_EQ(trees[2].triangles, trees[3].triangles);
  EXPECT_NE(trees[0].triangles, trees[2].triangles);
  for (const std::size_t i : {1u, 4u}) {
    EXPECT_FALSE(trees[i].points);
    EXPECT_FALSE(trees[i].triangles);
    EXPECT_NE(trees[i].error, "");
  }
}

TEST_F(RobotBodies, ATreeOfAReplacedFileHasOtherPoints) {
  folder_.write("ball", "1");
  const BoundedRobot robot = bound(link("a", meshVisual("ball")), {});
  folder_.write("new", "2");
  std::filesystem::rename(folder_ / "new", folder_ / "ball");
  const auto tree = loader_.loadTrees({"ball"}, source()).at(0);
  ASSERT_TRUE(tree.triangles);
  ASSERT_TRUE(tree.points);
  EXPECT_NE(tree.points, robot.mesh_uris.at("ball"));
  EXPECT_NEAR(tree.points->magnitude().z(), 2, 1e-6);
}

TEST_F(RobotBodies, ATreeThatIsTooLargeLeavesThePoints) {
  const std::string path = folder_.write("ball", "1");
  const BoundedRobot robot = bound(link("a", meshVisual("ball")), {});
  folder_.write("other", "2");
  limits_.max_bytes = 1000;
  const auto tree = loader_.loadTrees({"other", "ball"}, source()).at(1);
  EXPECT_FALSE(tree.triangles);
  EXPECT_EQ(tree.points, robot.mesh_uris.at("ball"));
  EXPECT_EQ(tree.error.find("distances are those of the convex hull of " + path + ": its 192 "),
            0u);
  EXPECT_NE(tree.error.find("the 1000 allowed; allow more"), std::string::npos) << tree.error;
}

TEST_F(RobotBodies, PointsInUseStayInUseWhereTheirTreeCannotBeRead) {
  folder_.write("ball", "1");
  bool fails = false;
  RobotLoader loader([&](const MeshFile& file) {
    if (fails) throw MeshError("reading it takes too long", MeshFault::kTooSlow);
    return read(file);
  });
  const auto mesh = loader.loadMeshes({"ball"}, source()).at(0);
  ASSERT_TRUE(mesh.points);
  fails = true;
  const auto tree = loader.loadTrees({"ball"}, source()).at(0);
  EXPECT_FALSE(tree.points);
  EXPECT_FALSE(tree.triangles);
  EXPECT_NE(tree.error.find("reading it takes too long; simplify the mesh"), std::string::npos);
  EXPECT_EQ(loader.loadMeshes({"ball"}, source()).at(0).points, mesh.points);
  fails = false;
  EXPECT_TRUE(loader.loadTrees({"ball"}, source()).at(0).triangles) << "it can be tried again";
}

}  // namespace
}  // namespace link_bounds
