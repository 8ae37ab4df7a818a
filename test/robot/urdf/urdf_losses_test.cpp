// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Geometry that urdfdom drops is found, numbered and explained; elements before it are kept.
#include <gtest/gtest.h>

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {
namespace {

const std::string kBall = "<geometry><sphere radius='1'/></geometry>";

std::string visual(const std::string& geometry) {
  return "<visual><geometry>" + geometry + "</geometry></visual>";
}

Link lossyLinkOf(const std::string& content) {
  return parseRobot("<robot name='r'><link name='l'>" + content + "</link></robot>").links.at(0);
}

/// The lost element of a link whose second visual is bad.
LostElement lossOf(const std::string& geometry) {
  const Link link = lossyLinkOf(visual("<sphere radius='1'/>") + visual(geometry));
  EXPECT_EQ(link.elements.size(), 1u) << geometry;
  if (link.lost.size() != 1) {
    ADD_FAILURE() << link.lost.size() << " losses for " << geometry;
    return {Purpose::kVisual, 0, ""};
  }
  return link.lost[0];
}

TEST(UrdfLosses, SizesThatAreNoThreeNumbers) {
  for (const char* size : {"nan nan nan", "1 2", "1 2 3 4", "1 inf 1", "1 1e999 1", "one 2 3", "",
                           "1,2,3", "1 2 0x10"}) {
    const LostElement lost = lossOf("<box size='" + std::string(size) + "'/>");
    EXPECT_EQ(lost.purpose, Purpose::kVisual) << size;
    EXPECT_EQ(lost.number, 2u) << size;
    EXPECT_NE(lost.reason.find("cannot be parsed"), std::string::npos) << lost.reason;
    EXPECT_EQ(lost.reason.find("Link ["), std::string::npos) << "not one of the robot";
  }
}

TEST(UrdfLosses, RadiiAndLengthsThatAreNoNumber) {
  for (const char* geometry : {"<sphere radius='nan'/>", "<sphere radius='big'/>", "<sphere/>",
                               "<cylinder radius='1' length='inf'/>", "<cylinder radius='1'/>"}) {
    EXPECT_EQ(lossOf(geometry).number, 2u) << geometry;
  }
}

TEST(UrdfLosses, AScaleOfOneNumber) {
  const LostElement lost = lossOf("<mesh filename='file:///a.stl' scale='0.001'/>");
  EXPECT_EQ(lost.number, 2u);
  EXPECT_NE(lost.reason.find("0.001"), std::string::npos) << lost.reason;
}

TEST(UrdfLosses, AMeshWithoutAFile) {
  EXPECT_EQ(lossOf("<mesh/>").number, 2u);
  EXPECT_EQ(lossOf("<mesh filename=''/>").number, 2u);
}

TEST(UrdfLosses, AShapeThatUrdfdomDoesNotKnow) {
  const LostElement lost = lossOf("<capsule radius='1' length='2'/>");
  EXPECT_NE(lost.reason.find("capsule"), std::string::npos) << lost.reason;
}

TEST(UrdfLosses, AnElementWithoutGeometry) {
  const Link link = lossyLinkOf("<visual><origin xyz='0 0 0'/></visual>");
  EXPECT_TRUE(link.elements.empty());
  EXPECT_EQ(link.lost.size(), 1u);
}

TEST(UrdfLosses, AnOriginThatIsNoPose) {
  const Link link = lossyLinkOf("<collision><origin xyz='0 0'/>" + kBall + "</collision>");
  ASSERT_EQ(link.lost.size(), 1u);
  EXPECT_EQ(link.lost[0].purpose, Purpose::kCollision);
  EXPECT_EQ(link.lost[0].number, 1u);
}

TEST(UrdfLosses, NumbersThatUrdfdomAcceptsButNobodyCanUse) {
  for (const char* geometry :
       {"<box size='1 -1 1'/>", "<sphere radius='-1'/>", "<cylinder radius='1' length='-2'/>"}) {
    EXPECT_NE(lossOf(geometry).reason.find("negative"), std::string::npos) << geometry;
  }
  EXPECT_NE(lossOf("<mesh filename='file:///a.stl' scale='1e31 1 1'/>").reason.find("1e30"),
            std::string::npos);
}

TEST(UrdfLosses, OneBadElementDoesNotHideWhyTheOthersAreGone) {
  const Link link =
      lossyLinkOf(visual("<sphere radius='1'/>") + visual("<box size='1 2'/>") +
                  visual("<sphere radius='2'/>") + "<collision>" + kBall + "</collision>");
  ASSERT_EQ(link.elements.size(), 1u) << "urdfdom stops at the first fault";
  EXPECT_EQ(link.elements[0].number, 1u);
  ASSERT_EQ(link.lost.size(), 3u);
  EXPECT_NE(link.lost[0].reason.find("cannot be parsed"), std::string::npos);
  EXPECT_EQ(link.lost[1].number, 3u);
  EXPECT_NE(link.lost[1].reason.find("another fault in this link"), std::string::npos);
  EXPECT_EQ(link.lost[2].purpose, Purpose::kCollision);
  EXPECT_EQ(link.lost[2].number, 1u);
}

TEST(UrdfLosses, ABadCollisionLeavesAllVisuals) {
  const Link link = lossyLinkOf("<collision>" + kBall + "</collision><collision/>" +
                                visual("<sphere radius='1'/>") + visual("<sphere radius='2'/>"));
  EXPECT_EQ(link.elements.size(), 3u);
  ASSERT_EQ(link.lost.size(), 1u);
  EXPECT_EQ(link.lost[0].purpose, Purpose::kCollision);
  EXPECT_EQ(link.lost[0].number, 2u);
}

TEST(UrdfLosses, ABadInertialTakesAllGeometryWithIt) {
  const Link link =
      lossyLinkOf("<inertial><mass value='heavy'/></inertial>" + visual("<sphere radius='1'/>") +
                  "<collision>" + kBall + "</collision>");
  EXPECT_TRUE(link.elements.empty());
  ASSERT_EQ(link.lost.size(), 2u);
  for (const LostElement& lost : link.lost) {
    EXPECT_EQ(lost.number, 1u);
    EXPECT_NE(lost.reason.find("another fault in this link"), std::string::npos) << lost.reason;
    EXPECT_NE(lost.reason.find("nertial"), std::string::npos) << lost.reason;
  }
}

TEST(UrdfLosses, OtherLinksAreNotConcerned) {
  const Robot robot = parseRobot(
      "<robot name='r'><link name='good'>" + visual("<sphere radius='1'/>") +
      "</link><link name='bad'>" + visual("<sphere/>") +
      "</link><joint name='j' type='fixed'><parent link='good'/><child link='bad'/></joint>"
      "</robot>");
  EXPECT_TRUE(robot.links[0].lost.empty());
  EXPECT_EQ(robot.links[0].elements.size(), 1u);
  EXPECT_EQ(robot.links[1].lost.size(), 1u);
}

TEST(UrdfLosses, AMaterialDefinedElsewhereIsNoFault) {
  const Robot robot = parseRobot(
      "<robot name='r'><material name='red'><color rgba='1 0 0 1'/></material><link name='l'>"
      "<visual>" +
      kBall +
      "<material name='red'/></visual>"
      "<visual>" +
      kBall + "<material name='unheard of'/></visual></link></robot>");
  EXPECT_EQ(robot.links[0].elements.size(), 2u);
  EXPECT_TRUE(robot.links[0].lost.empty());
}

/// Of which only the first part is read, and remains.
void expectSurplus(const std::string& element, const std::string& word) {
  const Link link = lossyLinkOf(element);
  EXPECT_EQ(link.elements.size(), 1u) << element;
  ASSERT_EQ(link.lost.size(), 1u) << element;
  EXPECT_EQ(link.lost[0].number, 1u);
  EXPECT_NE(link.lost[0].reason.find(word), std::string::npos) << link.lost[0].reason;
}

TEST(UrdfLosses, WhatAnElementHasTwice) {
  expectSurplus(visual("<box size='1 1 1'/><box size='5 5 5'/>"), "two shapes");
  expectSurplus(visual("<box size='1 1 1'/><!-- and --><cone/>"), "two shapes");
  expectSurplus("<visual>" + kBall + kBall + "</visual>", "two <geometry>");
  expectSurplus("<collision><origin/><origin xyz='1 0 0'/>" + kBall + "</collision>",
                "two <origin>");
}

TEST(UrdfLosses, ASecondPartOfTheSecondCollision) {
  const Link link = lossyLinkOf("<visual>" + kBall + "</visual><collision>" + kBall +
                                "</collision><collision>" + kBall + kBall + "</collision>");
  EXPECT_EQ(link.elements.size(), 3u);
  ASSERT_EQ(link.lost.size(), 1u);
  EXPECT_EQ(link.lost[0].purpose, Purpose::kCollision);
  EXPECT_EQ(link.lost[0].number, 2u);
}

TEST(UrdfLosses, NothingIsLostOfAGoodLink) {
  const Link link =
      lossyLinkOf(visual("<sphere radius='1'/>") + "<collision>" + kBall + "</collision>");
  EXPECT_EQ(link.elements.size(), 2u);
  EXPECT_TRUE(link.lost.empty());
}

}  // namespace
}  // namespace link_bounds
