// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One call from a description to boxes; single meshes; limits; what a loader keeps between loads.
#include "link_bounds/robot/robot_loader.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr char kTriangle[] =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\nendloop\n"
    "endfacet\nendsolid s\n";

TriangleMesh readTriangle(const MeshFile&) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

std::string robotWith(const std::string& mesh) {
  return "<robot name='r'><link name='bare'/><link name='arm'><visual><geometry><mesh filename='" +
         mesh +
         "'/></geometry></visual></link><joint name='j' type='fixed'><parent link='bare'/>"
         "<child link='arm'/></joint></robot>";
}

class RobotLoaderTest : public testing::Test {
 protected:
  RobotLoaderTest() { folder_.write("arm/a.stl", kTriangle); }

  PackagePath packages() const {
    return [this](const std::string& package) { return folder_ / package; };
  }

  TemporaryFolder folder_;
};

TEST_F(RobotLoaderTest, OneCallGivesTheRobotAndItsLinks) {
  const auto [robot, bounded] = loadRobot(robotWith("package://arm/a.stl"), {packages()});
  ASSERT_EQ(robot.links.size(), 2u);
  ASSERT_EQ(bounded.links.size(), 1u);
  EXPECT_EQ(bounded.indices, std::vector<std::size_t>{1});
  EXPECT_EQ(robot.links[bounded.indices[0]].name, bounded.links[0].name);
  const auto box = linkBox(bounded.links[0], Eigen::Affine3d::Identity());
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->max().y(), 2, 1e-12);
}

TEST_F(RobotLoaderTest, OneCallTakesABaseFolderLimitsAndASelection) {
  const std::string urdf = robotWith("a.stl");
  EXPECT_EQ(loadRobot(urdf, {}).bounded.problems.size(), 1u);
  EXPECT_TRUE(loadRobot(urdf, {nullptr, folder_ / "arm"}).bounded.problems.empty());
  const MeshSource small{nullptr, folder_ / "arm", nullptr, {30, sizeof(kTriangle) - 2}};
  const BoundedRobot refused = loadRobot(urdf, small).bounded;
  ASSERT_EQ(refused.problems.size(), 1u);
  EXPECT_NE(refused.problems[0].find("bytes are more than the"), std::string::npos);
  Selection collision;
  collision.visual = false;
  collision.collision = true;
  EXPECT_TRUE(loadRobot(urdf, {}, collision).bounded.links.empty());
  EXPECT_THROW(loadRobot("<robot", {}), RobotError);
}

TEST_F(RobotLoaderTest, ALaterLoadSharesPointsInUseAndTakesItsOwnLimits) {
  RobotLoader loader;
  const Robot robot = parseRobot(robotWith("package://arm/a.stl"));
  const MeshSource small{packages(), "", nullptr, {30, 10}};
  EXPECT_EQ(loader.load(robot, {}, small).problems.size(), 1u);
  EXPECT_EQ(loader.load(robot, {}, {packages()}).problems.size(), 1u) << "it remembers failures";
  loader.forgetFailures();
  const BoundedRobot first = loader.load(robot, {}, {packages()});
  ASSERT_TRUE(first.problems.empty());
  const BoundedRobot second = loader.load(robot, {}, {packages()});
  EXPECT_EQ(second.links.at(0).shapes.at(0).points, first.links.at(0).shapes.at(0).points);
  const auto object = loader.loadMeshes({"file://" + folder_ / "arm/a.stl"}, {});
  EXPECT_EQ(object.at(0).points, first.links.at(0).shapes.at(0).points);
}

TEST_F(RobotLoaderTest, ACancelledLoadEndsEarly) {
  RobotLoader loader;
  const Robot robot = parseRobot(robotWith("package://arm/a.stl"));
  const MeshSource source{packages(), "", nullptr, {}, [] { return true; }};
  const BoundedRobot bounded = loader.load(robot, {}, source);
  ASSERT_EQ(bounded.problems.size(), 1u);
  EXPECT_NE(bounded.problems[0].find("loading it was cancelled; try again"), std::string::npos);
}

std::string folderOf(const std::string& package) {
  if (package == "large") throw std::bad_alloc();
  if (package == "odd") throw std::logic_error("it is odd");
  return "";
}

/// The door to readers of other people.
TEST_F(RobotLoaderTest, WhatAReaderGivesIsChecked) {
  const std::string uri = "file://" + folder_ / "arm/a.stl";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
  const std::vector<Eigen::Vector3f> broken{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::pair<TriangleMesh, std::string>> refused{
      {{}, "it has no triangle"},
      {{corners, {}}, "it has no triangle"},
      {{corners, {{0, 1, 4}}}, "a triangle names vertex 4 of 4"},
      {{broken, {{0, 1, 2}}}, "a vertex that is not a finite number"}};
  for (const auto& [mesh, reason] : refused) {
    RobotLoader loader([mesh = mesh](const MeshFile&) { return mesh; });
    const LoadedMesh loaded = loader.loadMeshes({uri}, {}).at(0);
    EXPECT_FALSE(loaded.points);
    EXPECT_NE(loaded.error.find(reason), std::string::npos) << loaded.error;
    loader.forgetFailures();
    EXPECT_NE(loader.loadTrees({uri}, {}).at(0).error.find(reason), std::string::npos);
  }
}

/// A URDF that names a package is input, too.
TEST_F(RobotLoaderTest, NoPackagesAndWhatTheirSearchThrows) {
  const Robot robot = parseRobot(robotWith("package://odd/a.stl"));
  for (const PackagePath& packages : {PackagePath(), PackagePath(folderOf)}) {
    const BoundedRobot bounded = RobotLoader().load(robot, {}, {packages});
    ASSERT_EQ(bounded.problems.size(), 1u);
    EXPECT_NE(bounded.problems[0].find(packages ? "it is odd" : "there is no package \"odd\""),
              std::string::npos)
        << bounded.problems[0];
  }
}

std::string loaderRemedy(MeshFault fault) {
  return fault == MeshFault::kComputer    ? "end some"
         : fault == MeshFault::kCancelled ? "reload"
                                          : "";
}

TEST_F(RobotLoaderTest, AnExceptionIsTheReasonOfThatMeshAlone) {
  RobotLoader loader(readTriangle, loaderRemedy);
  const auto meshes = loader.loadMeshes({"package://large/a.stl", "file://" + folder_ / "arm/a.stl",
                                         "package://odd/a.stl", "package://missing/a.stl"},
                                        {folderOf});
  ASSERT_EQ(meshes.size(), 4u);
  EXPECT_FALSE(meshes[0].points);
  EXPECT_EQ(meshes[0].error, "it does not fit into memory; end some");
  EXPECT_TRUE(meshes[1].points);
  EXPECT_EQ(meshes[1].error, "");
  EXPECT_EQ(meshes[2].error, "unexpected: it is odd; reload");
  EXPECT_NE(meshes[3].error.find("there is no package"), std::string::npos);
}

}  // namespace
}  // namespace link_bounds
