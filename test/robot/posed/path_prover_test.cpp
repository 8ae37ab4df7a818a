// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Verdicts about segments beside dense samples of them.
#include "robot/posed/path_prover.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "link_bounds/geometry/distance/body_distances.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/urdf/simple_joints.h"
#include "testing/import_alone.h"
#include "testing/quad_poses.h"
#include "testing/robot_files.h"
#include "testing/sanitized.h"
#include "testing/thin_plates.h"

namespace link_bounds {
namespace {

constexpr double kTouch = 1e-7;  ///< m

bool isNeverOver() {
  return false;
}

using Model = LoadedRobot;

std::vector<PathBody> bodiesOf(const BoundedRobot& bounded) {
  std::vector<PathBody> bodies;
  for (std::size_t i = 0; i < bounded.links.size(); ++i)
    bodies.push_back({bounded.indices[i], bounded.bodies[i]});
  return bodies;
}

/// Without those that touch or nearly touch where all joints are at 0: they would end each search.
PathProver::Pairs pairsOf(const Model& model) {
  const RigidBodies rigid = rigidBodies(model.robot);
  const auto poses = linkPoses(model.robot, jointValues(model.robot, {}));
  PathProver::Pairs pairs;
  const auto& [robot, bounded] = model;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    for (std::size_t j = i + 1; j < bounded.links.size(); ++j) {
      if (areJoined(rigid, bounded.indices[i], bounded.indices[j])) continue;
      const auto distance =
          bodyDistance(bounded.bodies[i], Eigen::Affine3d(poses[bounded.indices[i]]),
                       bounded.bodies[j], Eigen::Affine3d(poses[bounded.indices[j]]));
      if (distance && distance->lower > 0.001) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

/// Positions within the limits, and velocities and accelerations of either sign.
WayPoint randomPoint(const Robot& robot, double time, int order, brute_force::Random& random) {
  WayPoint point;
  point.time = time;
  for (const Joint& joint : robot.joints) {
    const Limits limits = joint.limits.value_or(Limits{-1, 1});
    const double width = std::min(limits.upper - limits.lower, 2.0);
    point.positions.push_back(hasValue(joint.motion) ? random.uniform(-0.5, 0.5) * width : 0);
    if (order >= 3) point.velocities.push_back(hasValue(joint.motion) ? random.uniform(-1, 1) : 0);
    if (order >= 5)
      point.accelerations.push_back(hasValue(joint.motion) ? random.uniform(-2, 2) : 0);
  }
  return point;
}

/// Two points of two bodies, and how far they are apart.
struct Nearest {
  double distance;  ///< m
  std::size_t first = 0;
  std::size_t second = 0;
  Eigen::Vector3d on_first = Eigen::Vector3d::Zero();  ///< in the frame of the body
  Eigen::Vector3d on_second = Eigen::Vector3d::Zero();
};

std::vector<double> followed(const Robot& robot, const std::vector<double>& values) {
  std::vector<double> result = values;
  const std::vector<Lead> leads = leadsOf(robot);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = leads[i].factor * values[leads[i].leader] + leads[i].offset;
  return result;
}

/// Of all pairs; searches end where it is larger than `limit` [m].
Nearest nearestAt(const Model& model, const PathProver::Pairs& pairs,
                  const std::vector<double>& values, double limit, BodyDistances& distances) {
  const auto poses = linkPoses(model.robot, followed(model.robot, values));
  for (std::size_t i = 0; i < model.bounded.links.size(); ++i)
    distances.move(i, Eigen::Affine3d(poses[model.bounded.indices[i]]));
  distances.setGoal({1e-7, limit});
  Nearest nearest{limit};
  for (const auto& [first, second] : pairs) {
    const BodyDistance found = distances.find(first, second).value();
    if (!(found.upper < nearest.distance)) continue;
    const auto body = [&](std::size_t i, const Eigen::Vector3d& point) -> Eigen::Vector3d {
      return poses[model.bounded.indices[i]].inverse() * point;
    };
    nearest = {found.upper, first, second, body(first, found.on_first),
               body(second, found.on_second)};
  }
  return nearest;
}

/// How far the two points are apart, with poses in quadruple precision.
double quadDistance(const Model& model, const Nearest& nearest, const std::vector<double>& values) {
  const auto poses = quadLinkPoses(model.robot, followed(model.robot, values));
  const auto at = [&](std::size_t body, const Eigen::Vector3d& point) -> QuadColumn {
    return poses[model.bounded.indices[body]] * QuadColumn(point.cast<Quad>());
  };
  const QuadColumn between =
      at(nearest.first, nearest.on_first) - at(nearest.second, nearest.on_second);
  return static_cast<double>(quadRoot(between.dot(between)));
}

struct Counts {
  int safe = 0;
  int collides = 0;
  int undecided = 0;
};

void checkSegment(const Model& model, const PathProver::Pairs& pairs, const JointMotion& motion,
                  const SegmentProof& proof, BodyDistances& distances, int samples) {
  EXPECT_LE(proof.clearance, proof.nearest);
  const double at_witness =
      nearestAt(model, pairs, motion.at(proof.share), proof.nearest + 1, distances).distance;
  EXPECT_LE(at_witness, proof.nearest + 1e-7);
  EXPECT_TRUE(proof.verdict != PathVerdict::kCollides || at_witness <= kTouch + 1e-9) << at_witness;
  if (proof.clearance == 0) return;  // nothing is claimed
  for (int k = 0; k <= samples; ++k) {
    const std::vector<double> values = motion.at(double(k) / samples);
    const Nearest nearest = nearestAt(model, pairs, values, proof.clearance + 1e-3, distances);
    if (nearest.first == nearest.second) continue;  // all are farther apart
    ASSERT_GE(quadDistance(model, nearest, values), proof.clearance)
        << "at " << k << " of " << samples;
  }
}

void checkRobot(const RobotFile& file, int segments, int samples) {
  SCOPED_TRACE(file.name());
  const Model model = loadedAlone(withSimpleJoints(parseRobot(textOf(file.urdf))),
                                  file.package_path, collisionTriangles());
  const PathProver::Pairs pairs = pairsOf(model);
  if (pairs.empty()) return;
  BodyDistances distances;
  for (std::size_t i = 0; i < model.bounded.bodies.size(); ++i)
    distances.set(i, std::make_shared<const Body>(model.bounded.bodies[i]));
  brute_force::Random random(1);
  Counts counts;
  for (int i = 0; i < segments && !testing::Test::HasFatalFailure(); ++i) {
    const int order = 1 + 2 * (i % 3);
    const JointMotion motion(randomPoint(model.robot, 0, order, random),
                             randomPoint(model.robot, 1, order, random));
    PathProver prover(model.robot, bodiesOf(model.bounded), pairs, motion.ranges(), {});
    const SegmentProof proof = prover.prove(motion, isNeverOver);
    if (proof.verdict == PathVerdict::kSafe) ++counts.safe;
    if (proof.verdict == PathVerdict::kCollides) ++counts.collides;
    if (proof.verdict == PathVerdict::kUndecided) ++counts.undecided;
    checkSegment(model, pairs, motion, proof, distances, samples);
  }
  std::cout << file.name() << ": " << pairs.size() << " pairs, " << segments
            << " segments: " << counts.safe << " safe, " << counts.collides << " collide, "
            << counts.undecided << " undecided\n";
  EXPECT_EQ(counts.undecided, 0);
}

/// Segments of all public robots together, with 2,000 samples each; chosen for a long run.
int chosenSegments() {
  const char* const text = std::getenv("LINK_BOUNDS_TEST_SEGMENTS");
  return text ? std::atoi(text) : 0;
}

TEST(PathProver, NoSampleOfTheDemoIsNearerThanProven) {
  checkRobot(demoRobotFile(), repetitions(300), 100);
}

TEST(PathProver, NoSampleOfPublicRobotsIsNearerThanProven) {
  const std::vector<RobotFile> robots = publicRobotFiles();
  if (robots.empty())
    GTEST_SKIP() << "skipped: paths of public robots: LINK_BOUNDS_DATA is not set";
  const int chosen = chosenSegments();
  const int segments = chosen == 0 ? repetitions(10) : 1 + chosen / static_cast<int>(robots.size());
  for (const RobotFile& file : robots) {
    checkRobot(file, segments, chosen == 0 ? 50 : 2000);
    if (HasFatalFailure()) return;
  }
}

TEST(PathProver, FindsContactsBetweenSamples) {
  const int segments = repetitions(1000);
  const PlateCounts counts = crossedPlates(segments);
  EXPECT_EQ(counts.found, segments);
  std::cout << "samples at MoveIt's default step miss " << segments - counts.sampled << " of "
            << segments << " contacts\n";
  EXPECT_LT(counts.sampled, segments / 10);
}

TEST(PathProver, AContactAtAnEndIsFoundThere) {
  const LoadedRobot loaded = thinPlates();
  const WayPoint touching{{0, 1e-5}, {}, {}}, apart{{0, 0.5}, {}, {}};
  for (const double end : {0.0, 1.0}) {
    PathProver prover(loaded.robot, bodiesOf(loaded.bounded), {{0, 1}}, {{0, 0}, {0, 1}}, {});
    const JointMotion motion(end == 0 ? touching : apart, end == 0 ? apart : touching);
    const SegmentProof proof = prover.prove(motion, isNeverOver);
    EXPECT_EQ(proof.verdict, PathVerdict::kCollides);
    EXPECT_EQ(proof.share, end);
  }
}

TEST(PathProver, ClearanceIsThatOfTheNearestPose) {
  const LoadedRobot loaded = thinPlates();
  PathProver prover(loaded.robot, bodiesOf(loaded.bounded), {{0, 1}}, {{0, 0}, {0, 1}}, {0, 0.001});
  // There and back: a third of the way from 0.5 to 0.5 the plate is at 0.5 - 4/27.
  const JointMotion motion({{0, 0.5}, {0, -1}, {}, 0}, {{0, 0.5}, {0, 0}, {}, 1});
  const SegmentProof proof = prover.prove(motion, isNeverOver);
  const double expected = 0.5 - 4.0 / 27 - 1e-5;
  EXPECT_EQ(proof.verdict, PathVerdict::kSafe);
  EXPECT_LE(proof.clearance, expected + 1e-12);
  EXPECT_GE(proof.clearance, expected - 0.001 - 1e-9);
  EXPECT_NEAR(proof.share, 1.0 / 3, 0.1);
}

TEST(PathProver, AnIncompleteBodyIsNeverSafe) {
  const LoadedRobot loaded = thinPlates();
  std::vector<PathBody> bodies = bodiesOf(loaded.bounded);
  bodies[1].is_whole = false;
  PathProver prover(loaded.robot, bodies, {{0, 1}}, {{0, 0}, {0, 1}}, {});
  const JointMotion motion({{0, 0.5}, {}, {}}, {{0, 0.6}, {}, {}});
  const SegmentProof proof = prover.prove(motion, isNeverOver);
  EXPECT_EQ(proof.verdict, PathVerdict::kUndecided);
  EXPECT_EQ(proof.clearance, 0);
}

/// Its rotation would shrink the plate.
TEST(PathProver, AJointWithoutAnAxisIsRefused) {
  LoadedRobot loaded = thinPlates();
  for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
    for (Joint& joint : loaded.robot.joints) {
      joint.motion = motion;
      joint.axis.setZero();
    }
    EXPECT_THROW(
        {
          PathProver prover(loaded.robot, bodiesOf(loaded.bounded), {{0, 1}}, {{0, 0}, {0, 1}}, {});
          const JointMotion moves({{0, 0.5}, {}, {}}, {{0, 0.6}, {}, {}});
          prover.prove(moves, isNeverOver);
        },
        JointError);
  }
}

TEST(PathProver, WithoutTimeNothingIsDecided) {
  const LoadedRobot loaded = thinPlates();
  PathProver prover(loaded.robot, bodiesOf(loaded.bounded), {{0, 1}}, {{0, 0}, {0, 1}}, {});
  const JointMotion motion({{0, 0.5}, {}, {}}, {{0, 0.6}, {}, {}});
  const SegmentProof proof = prover.prove(motion, [] { return true; });
  EXPECT_EQ(proof.verdict, PathVerdict::kUndecided);
}

/// As ros_controllers' QuinticSplineSegment: the ends have the given values and derivatives.
TEST(JointMotion, KeepsItsEnds) {
  const WayPoint from{{0.3}, {-0.5}, {2}, 1};
  const WayPoint to{{-0.2}, {0.75}, {-1}, 3};
  for (const bool is_quintic : {false, true}) {
    WayPoint a = from;
    WayPoint b = to;
    if (!is_quintic) a.accelerations.clear();
    const JointMotion motion(a, b);
    const double h = 1e-5;  // of the duration, which is 2 s
    const auto at = [&](double share) { return motion.at(share)[0]; };
    EXPECT_NEAR(at(0), 0.3, 1e-15);
    EXPECT_NEAR(at(1), -0.2, 1e-15);
    EXPECT_NEAR((at(h) - at(-h)) / (2 * h) / 2, -0.5, 1e-8);
    EXPECT_NEAR((at(1 + h) - at(1 - h)) / (2 * h) / 2, 0.75, 1e-8);
    if (!is_quintic) continue;
    EXPECT_NEAR((at(h) - 2 * at(0) + at(-h)) / (h * h) / 4, 2, 1e-3);
    EXPECT_NEAR((at(1 + h) - 2 * at(1) + at(1 - h)) / (h * h) / 4, -1, 1e-3);
  }
}

TEST(JointMotion, SpreadHoldsForAllValues) {
  brute_force::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto number = [&] { return random.uniform(-2, 2); };
    const JointMotion motion({{number()}, {number()}, {number()}, 0},
                             {{number()}, {number()}, {number()}, random.uniform(0.1, 3)});
    const double half = random.uniform(0, 0.5);
    const double share = random.uniform(half, 1 - half);
    const double spread = motion.spread(0, share, half);
    for (int k = -20; k <= 20; ++k)
      ASSERT_LE(std::abs(motion.at(share + half * k / 20)[0] - motion.at(share)[0]), spread);
  }
}

}  // namespace
}  // namespace link_bounds
