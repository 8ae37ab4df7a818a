// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The box, time and completeness of a group.
#include "link_bounds/geometry/box/box_groups.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

BoxState whole(double x, std::int64_t stamp) {
  const Eigen::Vector3d min(x, -x, 0);
  return {Aabb(min, min + Eigen::Vector3d::Ones()), stamp, false};
}

BoxState partial(double x, std::int64_t stamp) {
  BoxState state = whole(x, stamp);
  state.incomplete = true;
  return state;
}

TEST(GroupState, BoxIsTheUnion) {
  const BoxState state = groupState({"g", {0, 1}}, {whole(0, 0), whole(3, 0)});
  ASSERT_TRUE(state.box);
  EXPECT_EQ(state.box->min(), Eigen::Vector3d(0, -3, 0));
  EXPECT_EQ(state.box->max(), Eigen::Vector3d(4, 1, 1));
  EXPECT_FALSE(state.incomplete);
}

TEST(GroupState, OnlyMembersCount) {
  const BoxState state = groupState({"g", {2}}, {partial(9, 1), BoxState{}, whole(1, 7)});
  EXPECT_EQ(state.box->max(), Eigen::Vector3d(2, 0, 1));
  EXPECT_EQ(state.stamp, 7);
  EXPECT_FALSE(state.incomplete);
}

TEST(GroupState, StampIsTheOldestThatIsNotZero) {
  EXPECT_EQ(groupState({"g", {0, 1, 2}}, {whole(0, 30), whole(0, 20), whole(0, 0)}).stamp, 20);
  EXPECT_EQ(groupState({"g", {0, 1, 2}}, {whole(0, 0), whole(0, 20), whole(0, 30)}).stamp, 20);
}

TEST(GroupState, StampOfStaticMembersIsZero) {
  EXPECT_EQ(groupState({"g", {0, 1}}, {whole(0, 0), whole(1, 0)}).stamp, 0);
}

TEST(GroupState, StampOfAMemberWithoutBoxDoesNotCount) {
  const BoxState missing{std::nullopt, 5, true};
  EXPECT_EQ(groupState({"g", {0, 1}}, {missing, whole(0, 20)}).stamp, 20);
}

TEST(GroupState, AMissingMemberMakesItIncompleteButKeepsTheOthers) {
  const BoxState state = groupState({"g", {0, 1}}, {BoxState{}, whole(1, 1)});
  ASSERT_TRUE(state.box);
  EXPECT_EQ(state.box->min(), Eigen::Vector3d(1, -1, 0));
  EXPECT_TRUE(state.incomplete);
}

TEST(GroupState, APartialMemberMakesItIncompleteAndCounts) {
  const BoxState state = groupState({"g", {0, 1}}, {partial(5, 1), whole(1, 1)});
  EXPECT_EQ(state.box->max(), Eigen::Vector3d(6, 0, 1));
  EXPECT_TRUE(state.incomplete);
}

TEST(GroupState, AMemberThatDoesNotExistMakesItIncomplete) {
  EXPECT_TRUE(groupState({"g", {0}, true}, {whole(1, 1)}).incomplete);
}

TEST(GroupState, NoMemberWithABoxGivesNone) {
  const BoxState state = groupState({"g", {0}}, {BoxState{}});
  EXPECT_FALSE(state.box);
  EXPECT_EQ(state.stamp, 0);
  EXPECT_TRUE(state.incomplete);
}

TEST(GroupState, AnEmptyGroupIsNotIncomplete) {
  const BoxState state = groupState({"g", {}}, {whole(1, 1)});
  EXPECT_FALSE(state.box);
  EXPECT_FALSE(state.incomplete);
}

}  // namespace
}  // namespace link_bounds
