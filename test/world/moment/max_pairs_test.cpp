// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which pairs are listed if there are more than max_pairs, beside a list of all.
#include <gtest/gtest.h>

#include <set>

#include "testing/brute_force.h"
#include "testing/live_boxes_testing.h"
#include "testing/marker_testing.h"
#include "testing/sanitized.h"
#include "world/moment/scene_distances.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;

constexpr double kAccuracy = 1e-4;
constexpr int kAll = 1'000'000;

struct Cuboid {
  Eigen::Vector3d size;
  Eigen::Affine3d pose;
};

MomentPtr madeMoment(const std::vector<Cuboid>& cuboids, int max_pairs) {
  auto model = std::make_shared<Model>(*modelOf("map", {}));
  model->parameters.distance_limit = 0.3;
  model->parameters.distance_accuracy = kAccuracy;
  model->parameters.max_pairs = max_pairs;
  auto moment = std::make_shared<Moment>();
  moment->model = model;
  moment->incomplete = {"o/0"};
  for (const Cuboid& cuboid : cuboids) {
    MarkerShape shape = markerShape(markerOf(Marker::CUBE, cuboid.size, 0));
    auto content = std::make_shared<ObjectContent>();
    content->bounded = {"o/" + std::to_string(moment->bodies.size()), shape.shapes, 0, ""};
    content->drawing = shape.drawing;
    const Aabb box = linkBox(content->bounded, cuboid.pose).value();
    moment->bodies.push_back({std::nullopt, content, 0, box, cuboid.pose});
  }
  return moment;
}

SceneDistances emptyDistances() {
  return SceneDistances({[](const std::string&, const auto&) {}, [](const auto&) {}});
}

ComputedDistances computed(const std::vector<Cuboid>& cuboids, int max_pairs,
                           SceneDistances& distances) {
  MomentPairs pairs;
  return distances.compute(madeMoment(cuboids, max_pairs), pairs, {}, [] { return false; }).value();
}

std::vector<double> sorted(const DistanceArray& array) {
  std::vector<double> result;
  for (const Distance& distance : array.distances)
    result.push_back(distance.distance);
  std::sort(result.begin(), result.end());
  return result;
}

/// Rods in any directions: their boxes say little of their distances.
std::vector<Cuboid> rods(brute_force::Random& random, std::size_t count) {
  std::vector<Cuboid> result(count, {{0.8, 0.02, 0.02}, Eigen::Affine3d::Identity()});
  for (Cuboid& rod : result) {
    rod.pose = Eigen::Affine3d(random.rotation());
    rod.pose.translation() = random.vector(0.4);
  }
  return result;
}

/// By first, then by second, in the order of the bodies.
bool isInOrder(const DistanceArray& array) {
  const auto number = [](const std::string& name) { return std::stoi(name.substr(2)); };
  std::vector<std::pair<int, int>> pairs;
  for (const Distance& distance : array.distances)
    pairs.emplace_back(number(distance.first), number(distance.second));
  return std::is_sorted(pairs.begin(), pairs.end());
}

void expectNearest(const ComputedDistances& found, const ComputedDistances& all, std::size_t max) {
  const std::vector<double> distances = sorted(found.array);
  const std::vector<double> expected = sorted(all.array);
  ASSERT_EQ(distances.size(), std::min(max, expected.size()));
  for (std::size_t i = 0; i < distances.size(); ++i)
    ASSERT_NEAR(distances[i], expected[i], 2 * kAccuracy);
  ASSERT_NEAR(found.nearest.distance, all.nearest.distance, 2 * kAccuracy);
  const std::vector<std::string>& incomplete = found.array.incomplete;
  const std::set<std::string> named(incomplete.begin(), incomplete.end());
  ASSERT_EQ(named.size(), incomplete.size()) << "a name twice";
  std::set<std::pair<std::string, std::string>> listed;
  for (const Distance& distance : found.array.distances)
    listed.insert({distance.first, distance.second});
  ASSERT_TRUE(isInOrder(found.array) && isInOrder(all.array));
  std::size_t missing = 0;
  for (const Distance& distance : all.array.distances) {
    if (listed.count({distance.first, distance.second})) continue;
    ++missing;
    ASSERT_TRUE(named.count(distance.first) && named.count(distance.second));
  }
  ASSERT_LE(missing, found.left_out);
}

TEST(MaxPairsTest, TheNearestPairsAreListedAndTheOthersNamed) {
  brute_force::Random random(1);
  std::size_t missing = 0;
  for (int round = 0; round < repetitions(40); ++round) {
    std::vector<Cuboid> cuboids = rods(random, 30);
    SceneDistances distances = emptyDistances();
    for (int step = 0; step < 4 && !testing::Test::HasFatalFailure(); ++step) {
      SceneDistances fresh = emptyDistances();
      const ComputedDistances all = computed(cuboids, kAll, fresh);
      EXPECT_EQ(all.left_out, 0U);
      EXPECT_EQ(all.array.incomplete, (std::vector<std::string>{"o/0"}));
      for (const int max : {1, 7, 20})
        expectNearest(computed(cuboids, max, distances), all, static_cast<std::size_t>(max));
      missing += all.array.distances.size() > 20 ? 1 : 0;
      for (Cuboid& cuboid : cuboids)
        cuboid.pose.translation() += random.vector(0.03);
    }
  }
  EXPECT_GT(missing, 0U) << "never too many pairs";
}

TEST(MaxPairsTest, ThePairsOfAllThatTouchAreNotMeasured) {
  constexpr std::size_t kCount = 200;
  constexpr std::size_t kPairs = kCount * (kCount - 1) / 2;
  constexpr int kMax = 100;
  const std::vector<Cuboid> cuboids(kCount, {{1, 1, 1}, Eigen::Affine3d::Identity()});
  SceneDistances distances = emptyDistances();
  std::size_t steps = 0;
  MomentPairs pairs;
  const auto found = distances.compute(madeMoment(cuboids, kMax), pairs, {}, [&] {
    ++steps;
    return false;
  });
  ASSERT_TRUE(found);
  EXPECT_EQ(found->array.distances.size(), std::size_t{kMax});
  EXPECT_EQ(found->left_out, kPairs - kMax);
  EXPECT_EQ(found->array.incomplete.size(), kCount);
  EXPECT_EQ(found->nearest.distance, 0);
  EXPECT_LE(steps, kPairs + kMax + 1) << "one per pair of boxes and one per measured pair";
}

TEST(MaxPairsTest, NamesOfWhichSilenceSaysNothingAreNotComplete) {
  using Names = std::vector<std::string>;
  const std::vector<Cuboid> cuboids(4, {{1, 1, 1}, Eigen::Affine3d::Identity()});
  auto moment = std::make_shared<Moment>(*madeMoment(cuboids, 5));
  SceneDistances distances = emptyDistances();
  const auto compute = [&](const char* name, const char* other, int max_pairs) {
    auto model = std::make_shared<Model>(*moment->model);
    model->ignored_pairs = NamePairs(std::vector<NamePair>{{name, other}});
    model->parameters.max_pairs = max_pairs;
    moment->model = model;
    moment->incomplete = {};
    MomentPairs pairs;
    return distances.compute(moment, pairs, {}, [] { return false; }).value().array;
  };
  DistanceArray found = compute("o/0", "o/1", 6);
  EXPECT_EQ(found.complete, Names({"o/0", "o/1", "o/2", "o/3"}));
  ASSERT_EQ(found.not_compared.size(), 1U);
  EXPECT_EQ(found.not_compared[0].second, "o/1");

  found = compute("o/0", "o/*", 3);
  EXPECT_EQ(found.not_compared.size(), 3U);
  EXPECT_EQ(found.incomplete, Names());
  EXPECT_EQ(found.complete, Names({"o/1", "o/2", "o/3"})) << "o/0 is compared with none";

  found = compute("o/*", "o/*", 2);
  EXPECT_EQ(found.not_compared.size(), 2U);
  EXPECT_EQ(found.incomplete, Names());
  EXPECT_EQ(found.complete, Names());
}

TEST(MaxPairsTest, PairsThatAreLeftOutAreNoMoreThanMaxPairs) {
  const std::vector<Cuboid> cuboids(6, {{1, 1, 1}, Eigen::Affine3d::Identity()});
  auto moment = std::make_shared<Moment>(*madeMoment(cuboids, 10));
  auto model = std::make_shared<Model>(*moment->model);
  model->ignored_pairs =
      NamePairs(std::vector<NamePair>{{"o/0", "o/1"}, {"o/2", "o/3"}, {"o/4", "o/5"}});
  model->parameters.max_pairs = 2;
  moment->model = model;
  moment->incomplete = {};
  for (std::size_t i = 0; i < 6; ++i) {  // two and two are near each other
    moment->bodies[i].box.translate(Eigen::Vector3d(9.0 * static_cast<double>(i / 2), 0, 0));
  }
  SceneDistances distances = emptyDistances();
  MomentPairs pairs;
  const DistanceArray found =
      distances.compute(moment, pairs, {}, [] { return false; }).value().array;
  EXPECT_EQ(found.not_compared.size(), 2U);
  EXPECT_EQ(found.incomplete, std::vector<std::string>());
  EXPECT_EQ(found.complete, (std::vector<std::string>{"o/0", "o/1", "o/2", "o/3"}));
}

TEST(MaxPairsTest, PairsThatAreExactlyAsManyAreAllListed) {
  const std::vector<Cuboid> cuboids(4, {{1, 1, 1}, Eigen::Affine3d::Identity()});
  SceneDistances distances = emptyDistances();
  const ComputedDistances found = computed(cuboids, 6, distances);
  EXPECT_EQ(found.array.distances.size(), 6U);
  EXPECT_EQ(found.left_out, 0U);
  EXPECT_EQ(found.array.incomplete, (std::vector<std::string>{"o/0"}));
}

}  // namespace
}  // namespace link_bounds
