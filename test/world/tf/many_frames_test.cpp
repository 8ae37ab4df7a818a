// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ten thousand frames and messages of thousands of transforms: exact, and cost as many links.
#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <iostream>
#include <limits>

#include "testing/live_boxes_testing.h"

namespace link_bounds {
namespace {

constexpr int kMany = 10000;
constexpr int kFew = 1000;
constexpr int kStrangers = 200000;
constexpr int kDeep = 20000;
constexpr int kShallow = 2000;
constexpr double kTolerance = 1e-9;  // m
constexpr double kQuadratic = 40;    // how much ten times the frames may cost; quadratic is 100
constexpr double kAsFlat = 3;  // times; with a path per link the first message costs five or more

const Eigen::Quaterniond kEighthTurn(Eigen::AngleAxisd(M_PI / 4,
                                                       Eigen::Vector3d(1, 2, 3).normalized()));

std::string name(int i) {
  return "frame_" + std::to_string(i);
}

double cpuMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

/// The milliseconds of the fastest of some updates.
template <class Links>
double best(Links&& links, int updates) {
  double result = links.update();
  for (int i = 1; i < updates; ++i)
    result = std::min(result, links.update());
  return result;
}

/// A small cube at the origin of its frame.
BoundedLink cube(const std::string& link) {
  Shape shape;
  shape.solid = Solid::kBox;
  shape.size = Eigen::Vector3d(0.2, 0.4, 0.6);
  return {link, {shape}, 0, ""};
}

/// Links on one base, the k-th at x = k.
class Star {
 public:
  explicit Star(int count) : count_(count) {
    std::vector<BoundedLink> links;
    for (int i = 0; i < count; ++i)
      links.push_back(cube(name(i)));
    scene_.adopt(modelOf("base", links), ros::Time(1));
  }

  /// Milliseconds of one message of all transforms and the update of all boxes.
  double update() {
    ++updates_;
    std::vector<geometry_msgs::TransformStamped> transforms;
    for (int i = 0; i < count_; ++i)
      transforms.push_back(
          edge("base", name(i), 1 + 0.01 * updates_, kEighthTurn, {1.0 * i, 0, 0}));
    const double start = cpuMilliseconds();
    tf_.add({transforms.begin(), transforms.end()}, false, ros::Time(1 + 0.01 * updates_));
    EXPECT_TRUE(scene_.update(ros::Time(1 + 0.01 * updates_)));
    return cpuMilliseconds() - start;
  }

  void expectExact() const {
    for (int i = 0; i < count_; ++i) {
      Eigen::Affine3d pose(kEighthTurn);
      pose.pretranslate(Eigen::Vector3d(i, 0, 0));
      const Aabb expected = linkBox(cube(name(i)), pose).value();
      const BoxState& state = scene_.links.states()[static_cast<std::size_t>(i)];
      ASSERT_TRUE(state.box && !state.incomplete) << name(i);
      EXPECT_LT((state.box->min() - expected.min()).norm(), kTolerance) << name(i);
      EXPECT_LT((state.box->max() - expected.max()).norm(), kTolerance) << name(i);
    }
  }

 private:
  const int count_;
  int updates_ = 0;
  TransformBuffer tf_;
  Scene scene_{tf_};
};

TEST(ManyFrames, AllExactFromOneMessage) {
  Star star(kMany);
  std::cout << "first message of " << kMany << " frames: " << star.update() << " ms\n";
  star.expectExact();
}

/// The updates take turns, so that neither set of links has the caches for itself.
TEST(ManyFrames, CostAsManyLinks) {
  Star many(kMany), few(kFew);
  double many_ms = many.update(), few_ms = few.update();
  for (int i = 1; i < 5; ++i) {
    many_ms = std::min(many_ms, many.update());
    few_ms = std::min(few_ms, few.update());
  }
  std::cout << "update of " << kFew << " links: " << few_ms << " ms, of " << kMany << ": "
            << many_ms << " ms\n";
  EXPECT_LT(many_ms, kQuadratic * few_ms);
}

TEST(ManyFrames, NewFramesOneByOneBesideALink) {
  TransformBuffer tf;
  Scene scene(tf);
  scene.adopt(modelOf("base", {cube("link")}), ros::Time(1));
  const double start = cpuMilliseconds();
  for (int i = 0; i < kMany; ++i) {
    tf.add({edge(i == 0 ? "base" : name(i - 1), name(i), 1, kEighthTurn, {1, 0, 0})}, false,
           ros::Time(1));
    EXPECT_FALSE(scene.update(ros::Time(1)));
  }
  std::cout << kMany << " messages of a new frame each: " << cpuMilliseconds() - start << " ms\n";
  tf.add({edge("base", "link", 1, kEighthTurn, {1, 0, 0})}, false, ros::Time(1));
  EXPECT_TRUE(scene.update(ros::Time(1)));
  EXPECT_TRUE(scene.links.states()[0].box);
}

/// The tree of followed frames is built again only when one of its own edges gets another parent.
TEST(ManyFrames, OfStrangersDoNotRebuildTheTree) {
  TransformBuffer tf;
  FrameTracker tracker(tf);
  tracker.setTarget("base", 0, ros::Time(1));
  const auto send = [&](const std::string& parent, const std::string& child) {
    tf.add({edge(parent, child, 1, kEighthTurn, {1, 0, 0})}, false, ros::Time(1));
    tracker.update(ros::Time(1));
  };
  for (int i = 0; i < kStrangers; ++i)
    tf.add({edge("base", name(i), 1, kEighthTurn, {1, 0, 0})}, false, ros::Time(1));
  const FrameTracker::Handle newest = tracker.follow(name(kStrangers - 1));
  const FrameTracker::Handle unknown = tracker.follow("unknown");
  tracker.update(ros::Time(1));
  ASSERT_EQ(newest.pose().problem, TransformProblem::kNone);
  const std::uint64_t structure = tf.structure();
  for (int i = 0; i < kFew; ++i) {
    send("base", "new_" + std::to_string(i));
    send(name(kStrangers - 1), "below_" + std::to_string(i));
    send("elsewhere_" + std::to_string(i), "beside_" + std::to_string(i));
  }
  EXPECT_EQ(tf.structure(), structure);
  EXPECT_EQ(unknown.pose().problem, TransformProblem::kNoTransform);
  send("below_0", "unknown");
  EXPECT_NE(tf.structure(), structure);
  EXPECT_EQ(unknown.pose().problem, TransformProblem::kNone);
}

/// Links on a chain, a step each, and one link beside it. tf2 takes more than a thousand steps for
/// a loop.
class Chain {
 public:
  Chain(int depth, const std::string& fixed_frame)
      : depth_(depth), top_from_fixed_(topFrom(fixed_frame)) {
    for (int i = 0; i < depth; ++i)
      links_.push_back(cube(name(i)));
    links_.push_back(cube("beside"));
    scene_.adopt(modelOf(fixed_frame, links_), ros::Time(1));
  }

  /// Milliseconds of one message of all transforms and the update of all boxes.
  double update() {
    const double stamp = 1 + 0.01 * ++updates_;
    std::vector<geometry_msgs::TransformStamped> transforms{
        edge("base", "beside", stamp, kEighthTurn, {0, 3, 0})};
    for (int i = 0; i < depth_; ++i)
      transforms.push_back(
          edge(i == 0 ? "base" : name(i - 1), name(i), stamp, step(), {0.01, 0, 0}));
    const double start = cpuMilliseconds();
    tf_.add({transforms.begin(), transforms.end()}, false, ros::Time(stamp));
    EXPECT_TRUE(scene_.update(ros::Time(stamp)));
    return cpuMilliseconds() - start;
  }

  void expectExact() const {
    for (int i = 0; i < depth_; i += depth_ / 100)
      expectExact(static_cast<std::size_t>(i), topFrom(name(i)));
    expectExact(links_.size() - 2, topFrom(name(depth_ - 1)));
    expectExact(links_.size() - 1, Eigen::Translation3d(0, 3, 0) * kEighthTurn);
  }

 private:
  /// A whole chain turns by half a turn, on a circle.
  Eigen::Quaterniond step() const {
    return Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / depth_, Eigen::Vector3d::UnitZ()));
  }

  Eigen::Isometry3d topFrom(const std::string& frame) const {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int i = 0; frame != "base"; ++i) {
      pose = pose * Eigen::Translation3d(0.01, 0, 0) * step();
      if (frame == name(i)) break;
    }
    return pose;
  }

  void expectExact(std::size_t i, const Eigen::Isometry3d& top_from_link) const {
    const BoxState& state = scene_.links.states()[i];
    ASSERT_TRUE(state.box) << links_[i].name << ": " << scene_.links.reason(i);
    const Aabb expected =
        linkBox(links_[i], Eigen::Affine3d(top_from_fixed_.inverse() * top_from_link)).value();
    EXPECT_LT((state.box->min() - expected.min()).norm(), kTolerance) << links_[i].name;
    EXPECT_LT((state.box->max() - expected.max()).norm(), kTolerance) << links_[i].name;
  }

  const int depth_;
  const Eigen::Isometry3d top_from_fixed_;
  std::vector<BoundedLink> links_;
  int updates_ = 0;
  TransformBuffer tf_;
  Scene scene_{tf_};
};

TEST(ManyFrames, DeepChainsAreExactEverywhere) {
  for (const int depth : {kShallow, kDeep}) {
    for (const std::string& fixed_frame : {std::string("base"), name(depth / 2), name(depth - 1)}) {
      SCOPED_TRACE(fixed_frame);
      Chain chain(depth, fixed_frame);
      const double first = chain.update();
      chain.expectExact();
      std::cout << "a chain of " << depth << " links in " << fixed_frame << ": first message "
                << first << " ms, then " << chain.update() << " ms\n";
      chain.expectExact();
    }
  }
}

TEST(ManyFrames, ADeepChainCostsAsAFlatTree) {
  double first_deep = std::numeric_limits<double>::infinity(), first_flat = first_deep;
  for (int i = 0; i < 3; ++i) {
    first_deep = std::min(first_deep, Chain(kDeep, name(kDeep / 2)).update());
    first_flat = std::min(first_flat, Star(kDeep).update());
  }
  std::cout << "first message of a chain of " << kDeep << " links: " << first_deep
            << " ms, of a flat tree: " << first_flat << " ms\n";
  EXPECT_LT(first_deep, kAsFlat * first_flat);
  EXPECT_LT(best(Chain(kDeep, name(kDeep / 2)), 5), kAsFlat * best(Star(kDeep), 5));
}

}  // namespace
}  // namespace link_bounds
