// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which bodies have a partner, beside a comparison of each with each.
#include "world/moment/compared_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

/// Links of a chain, then objects, all without geometry.
MomentPtr madeMoment(std::size_t links, const std::vector<std::string>& objects,
                     const std::vector<NamePair>& ignored, int joints) {
  std::vector<BoundedLink> bounded;
  for (std::size_t i = 0; i < links; ++i)
    bounded.push_back({"link" + std::to_string(i), {}, 0, ""});
  auto model = std::make_shared<Model>(*modelOf("map", bounded));
  for (std::size_t i = 1; i < links; ++i)
    model->bodies.parents[i] = i - 1;
  model->ignored_pairs = NamePairs(ignored);
  model->parameters.adjacent_joints = joints;
  auto moment = std::make_shared<Moment>();
  moment->model = model;
  for (std::size_t i = 0; i < links; ++i)
    moment->bodies.push_back({i, nullptr, 0, Aabb(), Eigen::Affine3d::Identity()});
  for (const std::string& name : objects) {
    auto content = std::make_shared<ObjectContent>();
    content->bounded.name = name;
    moment->bodies.push_back({std::nullopt, content, 0, Aabb(), Eigen::Affine3d::Identity()});
  }
  return moment;
}

std::vector<bool> eachWithEach(const Moment& moment) {
  const std::size_t count = moment.bodies.size();
  std::vector<bool> result(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (i != j && isPair(*moment.model, moment.member(i), moment.member(j))) result[i] = true;
    }
  }
  return result;
}

std::vector<std::string> namesOf(const std::string& space, std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i)
    names.push_back(space + "/" + std::to_string(i));
  return names;
}

std::vector<bool> all(std::size_t count, bool value) {
  return std::vector<bool>(count, value);
}

TEST(ComparedBodies, AloneThereIsNoPartner) {
  EXPECT_EQ(areCompared(*madeMoment(1, {}, {}, 1), {}), all(1, false));
  EXPECT_EQ(areCompared(*madeMoment(0, {"a/1"}, {}, 1), {}), all(1, false));
  EXPECT_TRUE(areCompared(*madeMoment(0, {}, {}, 1), {}).empty());
}

TEST(ComparedBodies, LinksThatAreAllJoinedHaveNone) {
  EXPECT_EQ(areCompared(*madeMoment(40, {}, {}, 1000), {}), all(40, false));
  EXPECT_EQ(areCompared(*madeMoment(40, {}, {}, 1), {}), all(40, true));
  EXPECT_EQ(areCompared(*madeMoment(40, {}, {{"*", "*"}}, 1), {}), all(40, false));
}

TEST(ComparedBodies, OnlyTheEndsOfAChainAreFarEnoughApart) {
  std::vector<bool> expected = all(40, false);
  expected.front() = expected.back() = true;
  EXPECT_EQ(areCompared(*madeMoment(40, {}, {}, 38), {}), expected);
}

TEST(ComparedBodies, OnePartnerFarDownTheListIsEnough) {
  std::vector<std::string> objects = namesOf("a", 50);
  EXPECT_EQ(areCompared(*madeMoment(0, objects, {{"a/*", "a/*"}}, 1), {}), all(50, false));
  objects.emplace_back("tool/1");
  EXPECT_EQ(areCompared(*madeMoment(0, objects, {{"a/*", "a/*"}}, 1), {}), all(51, true));
}

TEST(ComparedBodies, PairsThatAreKnownCount) {
  const auto moment = madeMoment(3, {}, {{"*", "*"}}, 1);
  EXPECT_EQ(areCompared(*moment, {{0, 2, 0.0}}), (std::vector<bool>{true, false, true}));
}

TEST(ComparedBodies, AreThoseOfEachWithEach) {
  brute_force::Random random(1);
  const std::vector<std::string> names{"*",     "a/*",   "b/*", "*/1",  "*/*",
                                       "link3", "link*", "a/1", "b/30", "a/2*"};
  const auto below = [&random](std::size_t count) {
    return static_cast<std::size_t>(random.uniform(0, static_cast<double>(count)));
  };
  std::size_t alone = 0;
  for (int round = 0; round < 150; ++round) {
    std::vector<std::string> objects = namesOf("a", below(40));
    for (const std::string& name : namesOf("b", below(40)))
      objects.push_back(name);
    std::vector<NamePair> ignored;
    for (std::size_t i = below(12); i > 0; --i)
      ignored.emplace_back(names[below(names.size())], names[below(names.size())]);
    const int joints = random.uniform(0, 1) < 0.3 ? 1000 : static_cast<int>(below(3));
    const auto moment = madeMoment(below(30), objects, ignored, joints);
    const std::vector<bool> expected = eachWithEach(*moment);
    ASSERT_EQ(areCompared(*moment, {}), expected) << round;
    alone += static_cast<std::size_t>(std::count(expected.begin(), expected.end(), false));
  }
  EXPECT_GT(alone, 300U);
}

}  // namespace
}  // namespace link_bounds
