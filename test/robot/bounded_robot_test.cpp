// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot are bounded, by what, and with how much padding.
#include <gtest/gtest.h>

#include <atomic>

#include "link_bounds/robot/robot_loader.h"
#include "testing/brute_force.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

constexpr double kTolerance = 1e-12;  // metres

/// Every file is a tetrahedron with legs of 1, 2 and 3 metres.
TriangleMesh tetrahedron(const MeshFile&) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 1, 2}, {0, 2, 3}}};
}

std::string fixed(const std::string& parent, const std::string& child) {
  return "<joint name='" + child + "_joint' type='fixed'><parent link='" + parent +
         "'/><child link='" + child + "'/></joint>";
}

class BoundRobot : public testing::Test {
 protected:
  BoundedRobot bound(const std::string& content, const Selection& selection = {}) {
    const Robot robot = parseRobot("<robot name='r'>" + content + "</robot>");
    return loader_.load(robot, selection, {nullptr, folder_.path().string(), nullptr});
  }

  TemporaryFolder folder_;
  std::atomic<int> imports_{0};
  RobotLoader loader_{[this](const MeshFile& file) {
    ++imports_;
    return tetrahedron(file);
  }};
};

std::vector<std::string> names(const BoundedRobot& robot) {
  std::vector<std::string> result;
  for (const BoundedLink& link : robot.links)
    result.push_back(link.name);
  return result;
}

using Names = std::vector<std::string>;

void expectBox(const BoundedLink& link, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  const auto box = linkBox(link, Eigen::Affine3d::Identity());
  ASSERT_TRUE(box) << link.name;
  EXPECT_LE((box->min() - min).cwiseAbs().maxCoeff(), kTolerance) << link.name;
  EXPECT_LE((box->max() - max).cwiseAbs().maxCoeff(), kTolerance) << link.name;
}

/// A link with a visual ball of radius 1 and a collision ball of radius 2.
std::string ballLink(const std::string& name) {
  return "<link name='" + name +
         "'><visual><geometry><sphere radius='1'/></geometry></visual>"
         "<collision><geometry><sphere radius='2'/></geometry></collision></link>";
}

const std::string kThreeBalls =
    ballLink("c") + ballLink("a") + ballLink("b") + fixed("c", "a") + fixed("a", "b");

std::string meshLink(const std::string& name, const std::string& scale) {
  return "<link name='" + name + "'><visual><geometry><mesh filename='part.stl' scale='" + scale +
         "'/></geometry></visual></link>";
}

TEST_F(BoundRobot, OneFileAtSeveralScalesIsImportedOnce) {
  folder_.write("part.stl");
  const BoundedRobot robot =
      bound(meshLink("metres", "1 1 1") + meshLink("millimetres", "0.001 0.001 0.001") +
            meshLink("mirrored", "-1 -1 -1") + fixed("metres", "millimetres") +
            fixed("metres", "mirrored"));
  ASSERT_EQ(robot.links.size(), 3u);
  expectBox(robot.links[0], {0, 0, 0}, {1, 2, 3});
  expectBox(robot.links[1], {0, 0, 0}, {0.001, 0.002, 0.003});
  expectBox(robot.links[2], {-1, -2, -3}, {0, 0, 0});
  EXPECT_EQ(imports_, 1);
  EXPECT_EQ(robot.links[0].shapes[0].points, robot.links[2].shapes[0].points);
}

TEST_F(BoundRobot, AllShapesOfALinkCount) {
  folder_.write("part.stl");
  const BoundedRobot robot = bound(
      "<link name='l'><visual><origin xyz='0 0 10'/><geometry><mesh filename='part.stl'/>"
      "</geometry></visual><visual><origin xyz='-5 0 0' rpy='0 0 0.7853981633974483'/><geometry>"
      "<box size='2 2 2'/></geometry></visual><visual><geometry><cylinder radius='0.5' length='2'/>"
      "</geometry></visual></link>");
  const double half_diagonal = std::sqrt(2.0);
  expectBox(robot.links.at(0), {-5 - half_diagonal, -half_diagonal, -1}, {1, 2, 13});
  EXPECT_TRUE(robot.links[0].isWhole());
  EXPECT_TRUE(robot.problems.empty());
}

TEST_F(BoundRobot, LinksComeInTheOrderOfTheText) {
  EXPECT_EQ(names(bound(kThreeBalls)), (Names{"c", "a", "b"}));
}

TEST_F(BoundRobot, OnlySelectedLinksAreBounded) {
  Selection selection;
  selection.links = {"b", "c", "nobody"};
  EXPECT_EQ(names(bound(kThreeBalls, selection)), (Names{"c", "b"}));
}

TEST_F(BoundRobot, IgnoredLinksAreNot) {
  Selection selection;
  selection.ignore_links = {"a", "nobody"};
  EXPECT_EQ(names(bound(kThreeBalls, selection)), (Names{"c", "b"}));
  selection.links = {"a", "b"};
  EXPECT_EQ(names(bound(kThreeBalls, selection)), (Names{"b"}));
}

TEST_F(BoundRobot, MeshesOfOtherLinksAreNotLoaded) {
  folder_.write("part.stl");
  Selection selection;
  selection.ignore_links = {"m"};
  bound(meshLink("m", "1 1 1"), selection);
  EXPECT_EQ(imports_, 0);
}

TEST_F(BoundRobot, GeometryIsVisualUnlessToldOtherwise) {
  const BoundedRobot robot = bound(ballLink("l"));
  EXPECT_EQ(robot.links.at(0).shapes.size(), 1u);
  expectBox(robot.links[0], {-1, -1, -1}, {1, 1, 1});
}

TEST_F(BoundRobot, GeometryMayBeCollision) {
  Selection selection;
  selection.visual = false;
  selection.collision = true;
  const BoundedRobot robot = bound(ballLink("l"), selection);
  EXPECT_EQ(robot.links.at(0).shapes.size(), 1u);
  expectBox(robot.links[0], {-2, -2, -2}, {2, 2, 2});
}

TEST_F(BoundRobot, GeometryMayBeBoth) {
  Selection selection;
  selection.collision = true;
  EXPECT_EQ(bound(ballLink("l"), selection).links.at(0).shapes.size(), 2u);
}

TEST_F(BoundRobot, PaddingOfALinkReplacesTheCommonOne) {
  Selection selection;
  selection.padding = 0.5;
  selection.link_padding = {{"a", 0.25}, {"b", 0}, {"nobody", 7}};
  const BoundedRobot robot = bound(kThreeBalls, selection);
  expectBox(robot.links.at(0), {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5});
  expectBox(robot.links.at(1), {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25});
  expectBox(robot.links.at(2), {-1, -1, -1}, {1, 1, 1});
}

TEST_F(BoundRobot, LinksWithoutSelectedGeometryAreAbsent) {
  const std::string collision_only =
      "<link name='hull'><collision><geometry><sphere radius='1'/></geometry></collision></link>";
  const BoundedRobot robot = bound("<link name='frame'/>" + collision_only + ballLink("ball") +
                                   fixed("frame", "hull") + fixed("frame", "ball"));
  EXPECT_EQ(names(robot), (Names{"ball"}));
  EXPECT_TRUE(robot.problems.empty());
}

TEST_F(BoundRobot, ReportsProgressOfTheFiles) {
  folder_.write("part.stl");
  std::size_t last = 0;
  const Robot robot = parseRobot("<robot name='r'>" + meshLink("m", "1 1 1") + "</robot>");
  loader_.load(robot, {},
               {nullptr, folder_.path().string(),
                [&](std::size_t done, std::size_t total) { last = 10 * done + total; }});
  EXPECT_EQ(last, 11u);
}

Selection inParts(int max_parts) {
  Selection selection;
  selection.parts_per_link = max_parts;
  selection.padding = 0.25;
  return selection;
}

TEST_F(BoundRobot, OnePartPerLinkIsNotMade) {
  folder_.write("part.stl");
  EXPECT_TRUE(bound(meshLink("a", "1 1 1"), inParts(1)).parts.empty());
}

TEST_F(BoundRobot, PartsHaveTheNameAndThePaddingOfTheLink) {
  const std::string two_balls =
      "<visual><origin xyz='-3 0 0'/><geometry><sphere radius='1'/></geometry></visual>"
      "<visual><origin xyz='3 0 1'/><geometry><sphere radius='1'/></geometry></visual>";
  const BoundedRobot robot = bound("<link name='a'>" + two_balls + "</link>", inParts(2));
  ASSERT_EQ(robot.parts.size(), 1u);
  ASSERT_EQ(robot.parts[0].size(), 2u);
  EXPECT_EQ(robot.parts[0][1].name, "a");
  expectBox(robot.parts[0][0], {-4.25, -1.25, -1.25}, {-1.75, 1.25, 1.25});
  expectBox(robot.parts[0][1], {1.75, -1.25, -0.25}, {4.25, 1.25, 2.25});
}

TEST_F(BoundRobot, LinksOfEqualShapesShareThePointsOfTheirParts) {
  folder_.write("part.stl");
  const BoundedRobot robot = bound(meshLink("a", "1 1 1") + meshLink("b", "1 1 1") +
                                       meshLink("c", "1 1 2") + fixed("a", "b") + fixed("a", "c"),
                                   inParts(2));
  ASSERT_EQ(robot.parts.size(), 3u);
  ASSERT_EQ(robot.parts[0].size(), 2u);
  EXPECT_EQ(robot.parts[0][0].shapes[0].points, robot.parts[1][0].shapes[0].points);
  EXPECT_NE(robot.parts[0][0].shapes[0].points, robot.parts[2][0].shapes[0].points);
  EXPECT_EQ(robot.parts[1][0].name, "b");
}

TEST_F(BoundRobot, AMeshThatFailsLeavesThePartsOfTheRest) {
  const BoundedRobot robot = bound(
      "<link name='a'><visual><geometry><mesh filename='lost.stl'/></geometry></visual>"
      "<visual><geometry><sphere radius='1'/></geometry></visual></link>" +
          meshLink("b", "1 1 1") + fixed("a", "b"),
      inParts(8));
  ASSERT_EQ(robot.parts.size(), 2u);
  ASSERT_EQ(robot.parts[0].size(), 1u);
  expectBox(robot.parts[0][0], {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25});
  EXPECT_TRUE(robot.parts[1].empty());
}

}  // namespace
}  // namespace link_bounds
