// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Geometry that cannot be bounded is reported, and everything else is still bounded.
#include <gtest/gtest.h>

#include "link_bounds/robot/robot_loader.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

const std::string kBall = "<visual><geometry><sphere radius='1'/></geometry></visual>";
const std::string kMissing =
    "<visual><geometry><mesh filename='package://arm/missing.stl'/></geometry></visual>";
const std::string kBroken =
    "<visual><geometry><mesh filename='package://arm/broken.stl'/></geometry></visual>";
const std::string kGood =
    "<visual><geometry><mesh filename='package://arm/good.stl'/></geometry></visual>";

class BoundRobotProblems : public testing::Test {
 protected:
  BoundRobotProblems() {
    folder_.write("arm/broken.stl");
    folder_.write("arm/good.stl");
  }

  BoundedRobot bound(const std::string& content, const Selection& selection = {}) {
    const Robot robot =
        parseRobot("<robot name='r'><link name='wrist'>" + content + "</link></robot>");
    const auto package_path = [this](const std::string& package) {
      return package == "arm" ? folder_ / "arm" : std::string();
    };
    return loader_.load(robot, selection, {package_path, "", nullptr});
  }

  TemporaryFolder folder_;
  RobotLoader loader_{[](const MeshFile& file) -> TriangleMesh {
    if (file.path.find("broken") != std::string::npos) throw MeshError("it has no triangle");
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  }};
};

void expectMentions(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in: " << text;
  }
}

TEST_F(BoundRobotProblems, AMissingMeshIsNamedWithLinkElementFileAndRemedy) {
  const BoundedRobot robot = bound(kBall + kMissing);
  ASSERT_EQ(robot.problems.size(), 1u);
  expectMentions(robot.problems[0], {"link \"wrist\"", "visual 2", "package://arm/missing.stl",
                                     folder_ / "arm/missing.stl", "install the file"});
}

TEST_F(BoundRobotProblems, ABrokenMeshIsNamedWithLinkElementFileReasonAndRemedy) {
  const BoundedRobot robot = bound(kBroken);
  ASSERT_EQ(robot.problems.size(), 1u);
  expectMentions(robot.problems[0],
                 {"link \"wrist\"", "visual 1", "package://arm/broken.stl",
                  folder_ / "arm/broken.stl", "it has no triangle", "replace the file"});
}

TEST_F(BoundRobotProblems, LostElementsAreNamedToo) {
  const BoundedRobot robot =
      bound(kBall + "<visual><geometry><box size='1 2'/></geometry></visual>");
  ASSERT_EQ(robot.problems.size(), 1u);
  expectMentions(robot.problems[0], {"link \"wrist\"", "visual 2", "correct"});
  EXPECT_FALSE(robot.links.at(0).isWhole());
}

TEST_F(BoundRobotProblems, OtherShapesOfTheLinkAreKept) {
  const BoundedRobot robot = bound(kBall + kMissing + kGood + kBroken);
  ASSERT_EQ(robot.links.size(), 1u);
  EXPECT_EQ(robot.links[0].shapes.size(), 2u);
  EXPECT_EQ(robot.problems.size(), 2u);
  EXPECT_FALSE(robot.links[0].isWhole());
  expectMentions(robot.links[0].missing, {"visual 2", "visual 4"});
  EXPECT_TRUE(linkBox(robot.links[0], Eigen::Affine3d::Identity()));
}

TEST_F(BoundRobotProblems, ALinkThatLostEverythingIsListedWithoutABox) {
  for (const std::string& content : {kMissing, kBroken}) {
    const BoundedRobot robot = bound(content);
    ASSERT_EQ(robot.links.size(), 1u);
    EXPECT_TRUE(robot.links[0].shapes.empty()) << "no point at the mesh's origin";
    EXPECT_FALSE(robot.links[0].isWhole());
    EXPECT_FALSE(linkBox(robot.links[0], Eigen::Affine3d::Identity()));
  }
}

TEST_F(BoundRobotProblems, EveryUseOfABrokenFileIsNamed) {
  const BoundedRobot robot = bound(kBroken + kGood + kBroken);
  ASSERT_EQ(robot.problems.size(), 2u);
  expectMentions(robot.problems[0], {"visual 1"});
  expectMentions(robot.problems[1], {"visual 3"});
}

TEST_F(BoundRobotProblems, GeometryThatIsNotAskedForIsNoProblem) {
  Selection selection;
  selection.visual = false;
  selection.collision = true;
  const BoundedRobot robot = bound(
      kMissing + "<collision><geometry><sphere radius='1'/></geometry></collision>", selection);
  EXPECT_TRUE(robot.problems.empty());
  EXPECT_TRUE(robot.links.at(0).isWhole());
}

TEST_F(BoundRobotProblems, LossesOfIgnoredLinksAreNoProblem) {
  Selection selection;
  selection.ignore_links = {"wrist"};
  const BoundedRobot robot = bound(kMissing + kBroken, selection);
  EXPECT_TRUE(robot.problems.empty());
  EXPECT_TRUE(robot.links.empty());
}

TEST_F(BoundRobotProblems, AnUnknownPackageIsNamed) {
  const BoundedRobot robot =
      bound("<visual><geometry><mesh filename='package://leg/a.stl'/></geometry></visual>");
  ASSERT_EQ(robot.problems.size(), 1u);
  expectMentions(robot.problems[0], {"no package \"leg\"", "ROS_PACKAGE_PATH"});
}

}  // namespace
}  // namespace link_bounds
