// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The pairs of one moment after another, beside a list made without memory.
#include "world/moment/moment_pairs.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "testing/brute_force.h"
#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

using Names = std::pair<std::size_t, std::size_t>;

std::shared_ptr<const ObjectContent> contentOf(const std::string& name) {
  auto content = std::make_shared<ObjectContent>();
  content->bounded.name = name;
  return content;
}

/// Objects o/0, o/1, ... and p/0, p/1, ..., of which "p/*" are no pairs among each other.
class MomentPairsTest : public testing::Test {
 protected:
  MomentPairsTest() {
    auto model = std::make_shared<Model>(*modelOf("map", {}));
    model->parameters.distance_limit = kLimit;
    model->parameters.max_pairs = kMaxPairs;
    model->ignored_pairs = NamePairs(std::vector<NamePair>{{"p/*", "p/*"}});
    model_ = model;
  }

  MomentPtr nextMoment() {
    auto moment = std::make_shared<Moment>();
    moment->model = model_;
    const int count = static_cast<int>(random_.uniform(0, 40));
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d center = random_.vector(1);
      const Eigen::Vector3d half = random_.vector(0.2).cwiseAbs();
      const std::string name = (i % 3 == 0 ? "p/" : "o/") + std::to_string(i);
      moment->bodies.push_back({std::nullopt, contentOf(name), 0,
                                Aabb(center - half, center + half), Eigen::Affine3d::Identity()});
    }
    return moment;
  }

  /// What the pairs must be, from all pairs of boxes.
  void expectAll(const Moment& moment, double margin, const NearPairs& near) {
    std::set<Names> expected;
    std::set<Names> left_out;
    for (std::size_t a = 0; a < moment.bodies.size(); ++a) {
      for (std::size_t b = a + 1; b < moment.bodies.size(); ++b) {
        const double distance = signedDistance(moment.bodies[a].box, moment.bodies[b].box);
        if (!isPair(*moment.model, moment.member(a), moment.member(b))) {
          if (distance <= std::min(kLimit, margin)) left_out.insert({a, b});
        } else if (distance <= margin) {
          expected.insert({a, b});
        }
      }
    }
    for (const BoxPair& pair : near.compared) {
      EXPECT_TRUE(isPair(*moment.model, moment.member(pair.first), moment.member(pair.second)));
      if (pair.distance <= margin) {
        EXPECT_EQ(expected.erase({pair.first, pair.second}), 1u);
      }
    }
    EXPECT_TRUE(expected.empty());
    for (const BoxPair& pair : near.left_out)
      left_out.erase({pair.first, pair.second});
    for (const auto& [a, b] : left_out)
      EXPECT_FALSE(near.is_listed[a] || near.is_listed[b]);
    cut_ += !left_out.empty();
    EXPECT_LE(near.left_out.size(), static_cast<std::size_t>(kMaxPairs));
    EXPECT_EQ(near.is_listed.size(), moment.bodies.size());
    found_ += near.compared.size();
  }

  static constexpr double kLimit = 0.3;
  static constexpr int kMaxPairs = 3;
  brute_force::Random random_{31};
  std::shared_ptr<const Model> model_;
  MomentPairs pairs_;
  std::size_t found_ = 0;
  int cut_ = 0;  ///< moments with more pairs left out than fit into the list
};

TEST_F(MomentPairsTest, AreThoseOfAllPairsAfterAnySequence) {
  int ended = 0;
  std::vector<MomentPtr> alive(3, nextMoment());
  for (int i = 0; i < 3000; ++i) {
    MomentPtr& moment = alive[static_cast<std::size_t>(random_.uniform(0, 3))];
    if (random_.uniform(0, 1) < 0.6) moment = nextMoment();
    if (random_.uniform(0, 1) < 0.2) pairs_.expect(random_.uniform(0, 0.6));
    if (random_.uniform(0, 1) < 0.1) pairs_.freeMemory();
    const double margin = random_.uniform(0, 1) < 0.5 ? kLimit : random_.uniform(0, 0.5);
    const bool is_ended = random_.uniform(0, 1) < 0.1;
    const auto read = [&](const NearPairs& near) { expectAll(*moment, margin, near); };
    if (!pairs_.read(moment, margin, read, [&] { return is_ended; })) {
      EXPECT_TRUE(is_ended);
      ++ended;
    }
  }
  EXPECT_GT(found_, 10'000u);
  EXPECT_GT(cut_, 100);
  EXPECT_GT(ended, 20);
}

TEST_F(MomentPairsTest, AreSearchedOnceForAllWhoAsk) {
  int looks = 0;
  const auto look = [&looks] {
    ++looks;
    return false;
  };
  const auto ask = [&](const MomentPtr& moment, double margin) {
    const int before = looks;
    EXPECT_TRUE(pairs_.read(
        moment, margin, [](const NearPairs&) {}, look));
    return looks > before;
  };
  auto moment = std::make_shared<Moment>(*nextMoment());
  while (moment->bodies.size() < 10)
    *moment = *nextMoment();
  pairs_.expect(1);
  EXPECT_TRUE(ask(moment, 0));
  EXPECT_FALSE(ask(moment, kLimit));
  EXPECT_FALSE(ask(moment, 1));
  EXPECT_TRUE(ask(std::make_shared<Moment>(*moment), 0.5));
  EXPECT_TRUE(ask(moment, 0.5));
}

}  // namespace
}  // namespace link_bounds
