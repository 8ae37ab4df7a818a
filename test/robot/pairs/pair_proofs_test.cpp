// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Verdicts about arms with known answers.
#include "robot/pairs/pair_proofs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <sstream>
#include <thread>

#include "testing/distance_bodies.h"
#include "testing/pair_proofs_testing.h"

namespace link_bounds {
namespace {

/// A robot of a chain of links, each with one shape or none.
class Chain {
 public:
  Chain() { text_ << "<robot name='r'><link name='0'>"; }

  /// At `xyz` of the last link.
  Chain& shape(const std::string& geometry, const std::string& xyz = "0 0 0") {
    text_ << "<visual><origin xyz='" << xyz << "'/><geometry>" << geometry
          << "</geometry></visual>";
    return *this;
  }

  /// `more` may have limits and a mimic element.
  Chain& joint(const std::string& type, const std::string& xyz, const std::string& axis,
               const std::string& more = "", int parent = -1) {
    ++links_;
    text_ << "</link><joint name='j" << links_ << "' type='" << type << "'><parent link='"
          << (parent < 0 ? links_ - 1 : parent) << "'/><child link='" << links_
          << "'/><origin xyz='" << xyz << "'/><axis xyz='" << axis << "'/>" << more
          << "</joint><link name='" << links_ << "'>";
    return *this;
  }

  Model model() const {
    Selection selection;
    selection.triangles = true;
    LoadedRobot loaded = loadRobot(text_.str() + "</link></robot>", {}, selection);
    return {std::move(loaded.robot), std::move(loaded.bounded)};
  }

 private:
  std::ostringstream text_;
  int links_ = 0;
};

std::string limits(double lower, double upper) {
  std::ostringstream text;
  text.precision(17);
  text << "<limit lower='" << lower << "' upper='" << upper << "' effort='1' velocity='1'/>";
  return text.str();
}

std::string ball(double radius) {
  std::ostringstream text;
  text.precision(17);
  text << "<sphere radius='" << radius << "'/>";
  return text.str();
}

/// Without a budget.
std::vector<PairProof> prove(const Model& model, const PairGoal& goal = {},
                             const GivenRanges& given = {}, unsigned threads = 2) {
  ProofControl control;
  control.threads = threads;
  return provePairs(model.robot, model.bounded, jointRanges(model.robot, given), goal, control);
}

/// Of the only pair.
void expectVerdict(const Model& model, Verdict verdict, double distance,
                   const PairGoal& goal = {0, 0.001}) {
  const std::vector<PairProof> proofs = prove(model, goal);
  ASSERT_EQ(proofs.size(), 1U);
  EXPECT_EQ(proofs[0].verdict, verdict);
  checkPose(model, proofs[0], goal);
  if (verdict != Verdict::kNever) return;
  EXPECT_LE(proofs[0].clearance, distance + 1e-7);
  EXPECT_GE(proofs[0].nearest, distance - 1e-7);
  EXPECT_LE(proofs[0].nearest - proofs[0].clearance, goal.accuracy + 1e-9);
}

/// A ball at the base, two links of 1 m and 0.7 m, and a ball at the tip. The elbow bends up to
/// `bend`, so the tip comes as near to the base as the third side of a triangle.
constexpr double kBend = 2.5;
const double kThirdSide = std::sqrt(1 + 0.49 - 2 * 0.7 * std::cos(M_PI - kBend));

Model planarArm(double gap) {
  return Chain()
      .shape(ball(0.2))
      .joint("continuous", "0 0 0", "0 0 1")
      .joint("revolute", "1 0 0", "0 0 1", limits(-1, kBend))
      .shape(ball(kThirdSide - 0.2 - gap), "0.7 0 0")
      .model();
}

TEST(PairProofs, PlanarArmJustAvoidsTouchesAndHitsItsBase) {
  expectVerdict(planarArm(0.003), Verdict::kNever, 0.003);
  expectVerdict(planarArm(1e-5), Verdict::kNever, 1e-5);
  expectVerdict(planarArm(0), Verdict::kSometimes, 0);
  expectVerdict(planarArm(-1e-6), Verdict::kSometimes, 0);
}

TEST(PairProofs, ClearanceMovesTheBorder) {
  expectVerdict(planarArm(0.05), Verdict::kNever, 0.05, {0.049, 0.001});
  expectVerdict(planarArm(0.05), Verdict::kSometimes, 0.05, {0.05, 0.001});
  expectVerdict(planarArm(0.05), Verdict::kSometimes, 0.05, {0.051, 0.001});
}

/// Three links of 0.5 m that can fold back to the base at an angle of 60 degrees.
TEST(PairProofs, ThreeLinksThatFoldToATriangle) {
  const auto arm = [](double lower, double gap) {
    return Chain()
        .shape("<box size='0.1 0.1 0.1'/>")
        .joint("continuous", "0 0 0", "0 0 1")
        .joint("revolute", "0.5 0 0", "0 0 1", limits(-2 * M_PI / 3, 0))
        .joint("revolute", "0.5 0 0", "0 0 1", limits(lower, 0))
        .shape(ball(0.05 - gap), "0.5 0 0")
        .model();
  };
  expectVerdict(arm(-2 * M_PI / 3, 0), Verdict::kSometimes, 0);
  // The third link then stays perpendicular to the second one or points away: the tip is as far
  // as where the ends of two sides of 60 degrees are, 0.5 m, plus what is missing to the base.
  const double across = std::hypot(0.5 - 0.5 * std::sin(M_PI / 3), 0.25);
  const double to_box = across - 0.05 * std::sqrt(2.0) - 0.05;
  const std::vector<PairProof> proofs = prove(arm(-M_PI / 2, 0), {0, 0.001});
  ASSERT_EQ(proofs.size(), 1U);
  EXPECT_EQ(proofs[0].verdict, Verdict::kNever);
  EXPECT_GE(proofs[0].nearest, to_box - 1e-6);
  EXPECT_LE(proofs[0].nearest - proofs[0].clearance, 0.001 + 1e-9);
}

TEST(PairProofs, SlidesEndBeforeAtAndBehindTheWall) {
  const auto slide = [](double upper) {
    return Chain()
        .shape("<box size='1 1 1'/>")
        .joint("prismatic", "-3 0 0", "1 0 0", limits(0, 1))
        .joint("prismatic", "0 0 0", "1 0 0", limits(0, upper))
        .shape("<box size='1 1 1'/>")
        .model();
  };
  expectVerdict(slide(0.995), Verdict::kNever, 0.005);
  expectVerdict(slide(1), Verdict::kSometimes, 0);
  expectVerdict(slide(1.005), Verdict::kSometimes, 0);
}

/// Two fingers, of which the second one mimics the first, or both mimic a joint that is elsewhere.
TEST(PairProofs, MimicJointsMoveTogether) {
  const auto gripper = [](double closed) {
    return Chain()
        .joint("prismatic", "1 0 0", "-1 0 0", limits(0, closed))
        .shape("<box size='0.2 0.1 0.1'/>")
        .joint("prismatic", "-1 0 0", "1 0 0",
               limits(0, 99) + "<mimic joint='j1' multiplier='0.5' offset='0.1'/>", 0)
        .shape("<box size='0.2 0.1 0.1'/>")
        .model();
  };
  // At j1 the gap is 2 - 0.2 - j1 - (0.5 j1 + 0.1).
  expectVerdict(gripper(1.13), Verdict::kNever, 1.7 - 1.5 * 1.13);
  expectVerdict(gripper(1.7 / 1.5), Verdict::kSometimes, 0);
  const std::vector<PairProof> proofs = prove(gripper(1));
  EXPECT_EQ(proofs[0].pose.size(), 1U) << "the follower has no value of its own";
  const Model elsewhere =
      Chain()
          .shape(ball(0.1))
          .joint("continuous", "9 0 0", "0 0 1", limits(-0.2, 0.2))
          .joint("continuous", "0 0 0", "0 0 1", "<mimic joint='j4' multiplier='2'/>", 0)
          .joint("fixed", "0.5 0 0", "0 0 1")
          .joint("revolute", "0 0 0", "0 0 1", limits(-0.3, 0.4), 0)
          .joint("continuous", "0 0 0", "0 0 1", "", 3)
          .shape(ball(0.1), "0.4 0 0")
          .model();
  expectVerdict(elsewhere, Verdict::kSometimes, 0);
}

/// The balls stay around the wrist, whatever the joints do.
TEST(PairProofs, BodiesAroundASharedAxisAlwaysCollide) {
  const auto wrist = [](double offset) {
    std::ostringstream xyz;
    xyz << offset << " 0 0";
    return Chain()
        .shape("<cylinder radius='0.2' length='0.3'/>")
        .joint("continuous", "0 0 0", "0 0 1")
        .joint("continuous", "0 0 0", "0 1 0")
        .shape("<box size='0.1 0.2 0.1'/>", xyz.str())
        .model();
  };
  expectVerdict(wrist(0.05), Verdict::kAlways, 0);
  expectVerdict(wrist(0.3), Verdict::kSometimes, 0);
}

/// Swept around a joint, the body is too large to be placed.
TEST(PairProofs, ASweptBodyThatIsTooLargeIsLeftOut) {
  const Model model = Chain()
                          .shape(ball(0.1))
                          .joint("prismatic", "0 0 0", "1 0 0", limits(0, 1))
                          .joint("revolute", "0 0 0", "0 0 1", limits(-1, 1))
                          .shape(ball(0.1), "9e59 0 0")
                          .model();
  // Rounding of numbers so large leaves no accuracy, so the search would not end.
  std::atomic<int> looks{0};
  ProofControl control;
  control.threads = 1;
  control.is_over = [&looks] { return ++looks > 1'000; };
  const std::vector<PairProof> proofs =
      provePairs(model.robot, model.bounded, jointRanges(model.robot, {}), {}, control);
  ASSERT_EQ(proofs.size(), 1U);
  EXPECT_EQ(proofs[0].verdict, Verdict::kNever);
}

TEST(PairProofs, WithoutAFreeJointOnePoseDecides) {
  const Model model = planarArm(-0.1);
  const auto with = [&](double bend) {
    return prove(model, {}, {{"j1", {0.3, 0.3}}, {"j2", {bend, bend}}}).at(0);
  };
  EXPECT_EQ(with(kBend).verdict, Verdict::kAlways);
  EXPECT_EQ(with(0).verdict, Verdict::kNever);
  EXPECT_FALSE(with(0).can_move);
  EXPECT_EQ(with(0).pose, (std::map<std::string, double>{{"j1", 0.3}}));
  EXPECT_NEAR(with(0).clearance, with(0).nearest, 1e-6);
}

TEST(PairProofs, GivenRangesReplaceLimits) {
  const Model model = planarArm(-0.1);
  EXPECT_EQ(prove(model, {}, {{"j2", {-1, 1}}}).at(0).verdict, Verdict::kNever);
  EXPECT_EQ(prove(model, {}, {{"j2", {-4e3, 4e3}}}).at(0).verdict, Verdict::kSometimes);
}

/// A hook of two boxes that encloses a ball: their hull overlaps it in every pose.
TEST(PairProofs, HullsThatOverlapProveNothing) {
  MeshBody bowl, stone;
  bowl.add(boxMesh({2, 2, 0.1}), Eigen::Affine3d(Eigen::Translation3d(0, 0, -0.4)));
  bowl.add(boxMesh({2, 0.1, 1}), Eigen::Affine3d(Eigen::Translation3d(0, 0.9, 0)));
  stone.add(boxMesh({0.2, 0.2, 0.2}));
  Model model = Chain()
                    .shape(ball(1))
                    .joint("continuous", "0 0 0", "0 0 1")
                    .joint("prismatic", "0 0 0", "1 0 0", limits(-0.5, 0.5))
                    .shape(ball(1))
                    .model();
  model.bounded.bodies = {bowl.body, stone.body};
  expectVerdict(model, Verdict::kNever, 0.85 - std::sqrt(0.1 * 0.1 + 0.6 * 0.6), {0, 0.01});
}

TEST(PairProofs, ThreadsDoNotChangeVerdicts) {
  const Model model = Chain()
                          .shape(ball(0.2))
                          .joint("continuous", "0 0 0.3", "0 0 1")
                          .joint("continuous", "0.3 0 0", "0 1 0")
                          .shape("<box size='0.2 0.1 0.1'/>")
                          .joint("revolute", "0.3 0 0", "0 1 0", limits(-1, 1))
                          .shape("<cylinder radius='0.05' length='0.3'/>")
                          .joint("revolute", "0.2 0 0", "1 0 1", limits(-2, 2))
                          .shape(ball(0.05), "0 0.1 0")
                          .model();
  const std::vector<PairProof> one = prove(model, {}, {}, 1), many = prove(model, {}, {}, 4);
  ASSERT_EQ(one.size(), 6U);
  ASSERT_EQ(many.size(), 6U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].verdict, many[i].verdict);
    EXPECT_EQ(one[i].clearance, many[i].clearance);
    EXPECT_EQ(one[i].pose, many[i].pose);
  }
}

/// A ball over a plate.
TEST(PairProofs, WhatStaysWithinTheToleranceTouches) {
  const auto sphere = [](double gap) {
    return Chain()
        .shape("<box size='2 2 1'/>")
        .joint("prismatic", "0 0 1", "1 0 0", limits(0, 0.005))
        .joint("prismatic", "0 0 0", "0 1 0", limits(0, 0.002))
        .shape(ball(0.5 - gap))
        .model();
  };
  PairGoal goal;
  goal.touching = 1e-3;
  expectVerdict(sphere(0), Verdict::kTouching, 0, goal);
  expectVerdict(sphere(5e-4), Verdict::kNever, 5e-4, goal);
  goal.touching = 0;
  expectVerdict(sphere(0), Verdict::kContactSampled, 0, goal);
}

/// A slope carries a box away from the other one.
TEST(PairProofs, WhatLeavesTheToleranceCollidesSometimes) {
  const Model model = Chain()
                          .shape("<box size='1 1 1'/>")
                          .joint("prismatic", "0 0 1", "1 0 1e-3", limits(0, 0.05))
                          .shape("<box size='1 1 1'/>")
                          .model();
  const auto verdict = [&](double touching) {
    PairGoal goal;
    goal.touching = touching;
    const auto proofs =
        provePairs(model.robot, model.bounded, jointRanges(model.robot), goal, {}, {true, false});
    EXPECT_TRUE(proofs.at(0).has_free_pose);
    return proofs.at(0).verdict;
  };
  EXPECT_EQ(verdict(1e-4), Verdict::kTouching);
  EXPECT_EQ(verdict(4e-5), Verdict::kSometimes);
}

/// Two joints have too many poses for a proof.
TEST(PairProofs, ContactThatIsNotProvenSaysHowManyPosesWereTried) {
  const Model model = Chain()
                          .shape("<box size='3 3 1'/>")
                          .joint("prismatic", "0 0 1", "1 0 0", limits(-1, 1))
                          .joint("prismatic", "0 0 0", "0 1 0", limits(-1, 1))
                          .shape("<box size='1 1 1'/>")
                          .model();
  const PairProof proof = prove(model).at(0);
  EXPECT_EQ(proof.verdict, Verdict::kContactSampled);
  EXPECT_GE(proof.poses, 300U);
  EXPECT_FALSE(proof.has_free_pose);
}

/// The links of a robot with an empty link after the base: base, first, second, welded, hand.
TEST(PairProofs, NeighboursAreLinksWithOneJointBetweenThem) {
  const Model model = Chain()
                          .shape(ball(0.1))
                          .joint("fixed", "0 0 1", "0 0 1")
                          .joint("continuous", "0 0 1", "0 0 1")
                          .shape(ball(0.1))
                          .joint("continuous", "0 0 0", "1 0 0")
                          .joint("continuous", "0 0 1", "0 0 1")
                          .shape(ball(0.1))
                          .joint("fixed", "0 0 1", "0 0 1")
                          .shape(ball(0.1))
                          .joint("continuous", "0 0 1", "0 0 1", "", 0)
                          .shape(ball(0.1))
                          .model();
  std::map<std::pair<std::size_t, std::size_t>, Verdict> verdicts;
  ProofControl control;
  control.is_over = [] { return true; };
  const auto ranges = jointRanges(model.robot);
  for (const PairProof& proof : provePairs(model.robot, model.bounded, ranges, {}, control))
    verdicts[{proof.first, proof.second}] = proof.verdict;
  EXPECT_EQ(verdicts.size(), 9U) << "all but the rigid pair";
  const auto isAdjacent = [&](std::size_t first, std::size_t second) {
    return verdicts.at({first, second}) == Verdict::kAdjacent;
  };
  EXPECT_TRUE(isAdjacent(0, 1)) << "through a link without geometry";
  EXPECT_TRUE(isAdjacent(0, 4));
  EXPECT_FALSE(isAdjacent(1, 2)) << "two joints that move";
  EXPECT_FALSE(isAdjacent(1, 3));
  EXPECT_FALSE(isAdjacent(1, 4)) << "the base is between them";
  EXPECT_EQ(verdicts.count({2, 3}), 0U);
  std::vector<PairProof> all =
      provePairs(model.robot, model.bounded, ranges, {}, control, {false, true});
  EXPECT_EQ(all.size(), 10U);
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& p) { return !p.is_rigid; }),
            all.end());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].verdict, Verdict::kAdjacent);
}

TEST(PairProofs, MemoryDoesNotChangeVerdicts) {
  const Model model = planarArm(1e-5);
  const PairGoal goal{0, 1e-6};
  ProofControl control;
  control.max_kept_bytes = 0;
  const auto ranges = jointRanges(model.robot);
  const PairProof kept = prove(model, goal).at(0);
  const PairProof again = provePairs(model.robot, model.bounded, ranges, goal, control).at(0);
  EXPECT_EQ(kept.verdict, Verdict::kNever);
  EXPECT_EQ(again.verdict, Verdict::kNever);
  EXPECT_EQ(again.clearance, kept.clearance);
  EXPECT_EQ(again.pose, kept.pose);
}

/// Calls of advance() until it is proven that the only pair never collides; at most 2,000.
std::size_t slicesOf(const Model& model, bool may_sweep) {
  const PairBody first = pairBody(model.bounded.bodies[0]);
  const PairBody second = pairBody(model.bounded.bodies[1]);
  const auto& indices = model.bounded.indices;
  PairSearch search(jointPath(model.robot, jointRanges(model.robot), indices[0], indices[1]), first,
                    second, {0, 1000}, may_sweep);
  while (!search.isDone() && search.slices() < 2000)
    search.advance();
  EXPECT_TRUE(search.isFree());
  return search.slices();
}

/// Two boxes that spin, and slide past each other.
TEST(PairProofs, BodiesThatSpinAreSweptToTakeFewerBoxes) {
  const Model model = Chain()
                          .shape("<box size='0.2 0.2 0.05'/>")
                          .joint("continuous", "0 0 0", "0 0 1")
                          .joint("prismatic", "0.3 0 0", "0 1 0", limits(-0.5, 0.5))
                          .joint("revolute", "0 0 0.01", "1 0 0", limits(-0.3, 0.3))
                          .joint("continuous", "0 0 0.01", "0 0 1")
                          .shape("<box size='0.2 0.2 0.05'/>")
                          .model();
  EXPECT_LT(2 * slicesOf(model, true), slicesOf(model, false));
}

TEST(PairProofs, CoordinatesWithoutAFiniteDistanceLeaveAPairUndecided) {
  for (const char* xyz : {"1e61 0 0", "1e200 0 0"}) {
    const Model model = Chain()
                            .shape(ball(0.2))
                            .joint("continuous", "0 0 0", "0 0 1")
                            .joint("continuous", xyz, "0 0 1")
                            .shape(ball(0.2))
                            .model();
    const PairProof proof = prove(model).at(0);
    EXPECT_EQ(proof.verdict, Verdict::kUndecided);
    EXPECT_EQ(proof.clearance, 0);
  }
}

TEST(PairProofs, IncompleteLinksNeverGetANever) {
  Model model = planarArm(0.3);
  model.bounded.links[1].missing = "a mesh";
  const PairProof proof = prove(model).at(0);
  EXPECT_EQ(proof.verdict, Verdict::kUndecided);
  EXPECT_EQ(proof.clearance, 0);
}

/// No pose was tried, as no search was made.
TEST(PairProofs, EndsWhenItIsOver) {
  const Model model = planarArm(1e-6);
  ProofControl control;
  control.is_over = [] { return true; };
  const auto proofs = provePairs(model.robot, model.bounded, jointRanges(model.robot), {}, control);
  ASSERT_EQ(proofs.size(), 1U);
  EXPECT_EQ(proofs[0].verdict, Verdict::kUndecided);
  EXPECT_EQ(proofs[0].clearance, 0);
  EXPECT_EQ(proofs[0].poses, 0U);
  EXPECT_TRUE(std::isinf(proofs[0].nearest));
}

/// Each thread looks whether it is over.
TEST(PairProofs, NoMoreThreadsThanPairs) {
  const Model model = planarArm(1e-6);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  ProofControl control;
  control.threads = 16;
  control.is_over = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    threads.insert(std::this_thread::get_id());
    return true;
  };
  provePairs(model.robot, model.bounded, jointRanges(model.robot), {}, control);
  EXPECT_EQ(threads.size(), 1U);
}

/// With one thread, which waits before each slice of work.
std::vector<PairProof> proveSlowly(const Model& model, int slices,
                                   std::chrono::milliseconds before_each) {
  ProofControl control;
  control.threads = 1;
  control.is_over = [&slices, before_each] {
    std::this_thread::sleep_for(before_each);
    return --slices < 0;
  };
  return provePairs(model.robot, model.bounded, jointRanges(model.robot), {}, control);
}

TEST(PairProofs, ASlowMachineDoesTheSameWorkForEachPair) {
  Chain chain;
  for (int i = 0; i < 6; ++i)
    chain.shape(ball(0.06)).joint("revolute", "0.13 0 0", "0 1 0.3", limits(-2, 2));
  const Model model = chain.shape(ball(0.06)).model();
  constexpr int kSlices = 40;  // too few for all pairs
  const auto fast = proveSlowly(model, kSlices, std::chrono::milliseconds(0));
  const auto slow = proveSlowly(model, kSlices, std::chrono::milliseconds(3));
  ASSERT_EQ(fast.size(), slow.size());
  for (std::size_t i = 0; i < fast.size(); ++i) {
    EXPECT_EQ(fast[i].verdict, slow[i].verdict) << i;
    EXPECT_EQ(fast[i].poses, slow[i].poses) << i;
    EXPECT_EQ(fast[i].clearance, slow[i].clearance) << i;
  }
  const auto tried = [](const PairProof& proof) { return proof.poses > 0; };
  EXPECT_EQ(std::count_if(fast.begin(), fast.end(), tried), 6);  // of 15
}

}  // namespace
}  // namespace link_bounds
