// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a robot description becomes: links, elements, origins, sizes and joints.
#include "link_bounds/robot/urdf/robot.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <functional>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

using brute_force::turned;

constexpr double kOriginTolerance = 1e-12;

std::string inRobot(const std::string& content) {
  return "<robot name='r'>" + content + "</robot>";
}

/// A robot of one link, and that link.
Link linkOf(const std::string& content) {
  const Robot robot = parseRobot(inRobot("<link name='l'>" + content + "</link>"));
  EXPECT_TRUE(robot.links.at(0).lost.empty());
  return robot.links.at(0);
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& type = "fixed", const std::string& content = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + content + "</joint>";
}

std::vector<std::string> linkNames(const Robot& robot) {
  std::vector<std::string> result;
  for (const Link& link : robot.links)
    result.push_back(link.name);
  return result;
}

TEST(ParseRobot, LinksKeepTheOrderOfTheText) {
  const Robot robot = parseRobot(inRobot("<link name='zebra'/>" + joint("j2", "mule", "ant") +
                                         "<link name='mule'/>" + joint("j1", "zebra", "mule") +
                                         "<link name='ant'/>"));
  EXPECT_EQ(linkNames(robot), (std::vector<std::string>{"zebra", "mule", "ant"}));
  EXPECT_EQ(robot.name, "r");
  EXPECT_EQ(robot.root, 0u);
  EXPECT_TRUE(robot.warnings.empty());
}

TEST(ParseRobot, TheRootNeedNotComeFirst) {
  const Robot robot = parseRobot(inRobot("<link name='a'/><link name='b'/><link name='c'/>" +
                                         joint("j", "c", "b") + joint("k", "b", "a")));
  EXPECT_EQ(robot.root, 2u);
}

TEST(ParseRobot, EveryVisualAndCollisionIsThere) {
  const std::string box = "<geometry><box size='1 1 1'/></geometry>";
  const std::string ball = "<geometry><sphere radius='1'/></geometry>";
  const Link link =
      linkOf("<visual>" + box + "</visual><collision>" + ball + "</collision><visual>" + ball +
             "</visual><collision>" + box + "</collision><visual>" + box + "</visual>");
  ASSERT_EQ(link.elements.size(), 5u);
  std::string order;
  for (const Element& element : link.elements) {
    order += std::string(toText(element.purpose)) + std::to_string(element.number) +
             (element.solid == Solid::kBox ? "box " : "ball ");
  }
  EXPECT_EQ(order, "visual1box visual2ball visual3box collision1ball collision2box ");
}

TEST(ParseRobot, SolidsHaveFullExtents) {
  const auto sizeIn = [](const std::string& geometry) {
    return linkOf("<visual><geometry>" + geometry + "</geometry></visual>").elements.at(0).size;
  };
  EXPECT_EQ(sizeIn("<box size='0.1 0.2 0.3'/>"), Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(sizeIn("<sphere radius='0.25'/>"), Eigen::Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(sizeIn("<cylinder radius='0.25' length='2'/>"), Eigen::Vector3d(0.5, 0.5, 2));
}

TEST(ParseRobot, SolidsHaveTheirKind) {
  const auto solidIn = [](const std::string& geometry) {
    return linkOf("<visual><geometry>" + geometry + "</geometry></visual>").elements.at(0).solid;
  };
  EXPECT_EQ(solidIn("<box size='1 1 1'/>"), Solid::kBox);
  EXPECT_EQ(solidIn("<sphere radius='1'/>"), Solid::kEllipsoid);
  EXPECT_EQ(solidIn("<cylinder radius='1' length='1'/>"), Solid::kCylinder);
  EXPECT_EQ(solidIn("<mesh filename='file:///a.stl'/>"), Solid::kNone);
}

TEST(ParseRobot, AFlatBoxIsNotAFault) {
  EXPECT_EQ(linkOf("<visual><geometry><box size='1 0 1'/></geometry></visual>").elements.size(),
            1u);
}

TEST(ParseRobot, AMeshKeepsItsUriAsWritten) {
  const Link link = linkOf(
      "<collision><geometry><mesh filename='package://p/a%20b &amp; c.STL'/></geometry>"
      "</collision>");
  EXPECT_EQ(link.elements.at(0).mesh_uri, "package://p/a%20b & c.STL");
  EXPECT_TRUE(link.elements.at(0).link_from_shape.matrix().isIdentity(0));
}

TEST(ParseRobot, OriginIsYawTimesPitchTimesRoll) {
  const Link link = linkOf(
      "<visual><origin xyz='1 2 3' rpy='0.5235987755982988 0.7853981633974483 0.3'/>"
      "<geometry><box size='1 1 1'/></geometry></visual>");
  const Eigen::Matrix3d expected = turned(0.3 * 180 / M_PI, Eigen::Vector3d::UnitZ()) *
                                   turned(45, Eigen::Vector3d::UnitY()) *
                                   turned(30, Eigen::Vector3d::UnitX());
  const Eigen::Affine3d& pose = link.elements.at(0).link_from_shape;
  EXPECT_TRUE(pose.linear().isApprox(expected, kOriginTolerance));
  EXPECT_EQ(pose.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(ParseRobot, MeshScaleComesBeforeTheOrigin) {
  const Link link = linkOf(
      "<visual><origin xyz='1 2 3' rpy='0 0 0.5235987755982988'/>"
      "<geometry><mesh filename='file:///a.stl' scale='0.001 -2 3'/></geometry></visual>");
  const Eigen::Matrix3d expected =
      turned(30, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0.001, -2, 3).asDiagonal();
  const Eigen::Affine3d& pose = link.elements.at(0).link_from_shape;
  EXPECT_TRUE(pose.linear().isApprox(expected, kOriginTolerance));
  EXPECT_EQ(pose.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(ParseRobot, JointsHaveTheirMotion) {
  const std::string limit = "<limit lower='-1' upper='1' effort='1' velocity='1'/>";
  std::string text = "<link name='base'/>";
  for (const char* type : {"fixed", "revolute", "continuous", "prismatic", "floating", "planar"}) {
    text += std::string("<link name='") + type + "'/>" + joint(type, "base", type, type, limit);
  }
  const Robot robot = parseRobot(inRobot(text));
  ASSERT_EQ(robot.joints.size(), 6u);
  for (const Joint& j : robot.joints) {
    const Motion expected = j.name == "revolute" || j.name == "continuous" ? Motion::kRotation
                            : j.name == "prismatic"                        ? Motion::kTranslation
                            : j.name == "floating"                         ? Motion::kFloating
                            : j.name == "planar"                           ? Motion::kPlanar
                                                                           : Motion::kNone;
    EXPECT_EQ(j.motion, expected) << j.name;
    EXPECT_EQ(robot.links[j.parent].name, "base");
    EXPECT_EQ(robot.links[j.child].name, j.name);
  }
}

TEST(ParseRobot, AxesHaveUnitLength) {
  const Robot robot =
      parseRobot(inRobot("<link name='a'/><link name='b'/><link name='c'/><link name='d'/>" +
                         joint("j", "a", "b", "continuous", "<axis xyz='0 3 -4'/>") +
                         joint("k", "b", "c", "continuous", "<axis xyz='0 0 0'/>") +
                         joint("l", "c", "d", "continuous")));
  EXPECT_TRUE(robot.joints[0].axis.isApprox(Eigen::Vector3d(0, 0.6, -0.8), kOriginTolerance));
  EXPECT_EQ(robot.joints[1].axis, Eigen::Vector3d::Zero());
  EXPECT_EQ(robot.joints[2].axis, Eigen::Vector3d::UnitX()) << "the default of URDF";
}

TEST(ParseRobot, MimicIsRead) {
  const Robot robot = parseRobot(inRobot(
      "<link name='a'/><link name='b'/><link name='c'/>" + joint("j", "a", "b", "continuous") +
      joint("k", "b", "c", "continuous", "<mimic joint='j' multiplier='-0.5' offset='0.25'/>")));
  EXPECT_FALSE(robot.joints[0].mimic);
  ASSERT_TRUE(robot.joints[1].mimic);
  EXPECT_EQ(robot.joints[1].mimic->joint, "j");
  EXPECT_EQ(robot.joints[1].mimic->multiplier, -0.5);
  EXPECT_EQ(robot.joints[1].mimic->offset, 0.25);
}

TEST(ParseRobot, ParentsStandBeforeTheirChildren) {
  const Robot robot = parseRobot(
      inRobot("<link name='d'/><link name='c'/><link name='b'/><link name='a'/><link name='e'/>" +
              joint("a_last", "c", "d") + joint("b_mid", "b", "c") + joint("z_first", "a", "b") +
              joint("side", "a", "e")));
  std::vector<bool> placed(robot.links.size(), false);
  placed[robot.root] = true;
  for (const Joint& j : robot.joints) {
    EXPECT_TRUE(placed[j.parent]) << j.name;
    placed[j.child] = true;
  }
  EXPECT_EQ(robot.joints.size(), 4u);
}

/// Runs `task` on a stack of 256 KiB, where recursion over links does not get far.
void onSmallStack(std::function<void()> task) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 256 * 1024), 0);
  const auto run = [](void* argument) -> void* {
    (*static_cast<std::function<void()>*>(argument))();
    return nullptr;
  };
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, run, &task), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
}

TEST(ParseRobot, AChainDeeperThanTheStack) {
  // With rising names the root is freed last, when nothing else holds its children any more.
  constexpr std::size_t kFirst = 100000;
  constexpr std::size_t kLinks = 20000;
  const auto name = [](std::size_t i) { return std::to_string(kFirst + i); };
  std::string text;
  for (std::size_t i = 0; i < kLinks; ++i) {
    text += "<link name='" + name(i) + "'/>";
    if (i > 0) text += joint(name(i), name(i - 1), name(i));
  }
  onSmallStack([&] {
    const Robot robot = parseRobot(inRobot(text));
    EXPECT_EQ(robot.links.size(), kLinks);
    EXPECT_EQ(robot.joints.back().name, name(kLinks - 1));
  });
}

}  // namespace
}  // namespace link_bounds
