// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Stops of random arms, of the demo robot and of the robots of LINK_BOUNDS_DATA: no pose on the way
// leaves the box of the stop, and near faces not in quadruple precision either.
// LINK_BOUNDS_TEST_SAMPLES says how many stops of each robot are tried, and LINK_BOUNDS_TEST_ROBOT
// of which robot of LINK_BOUNDS_DATA only.
#include "robot/stopping/moving_link.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <limits>
#include <mutex>
#include <sstream>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/stopping/joint_fit.h"
#include "robot/stopping/stop_offsets.h"
#include "robot/urdf/joints_above.h"
#include "robot/worker/mesh_import.h"
#include "testing/brute_force.h"
#include "testing/quad_poses.h"
#include "testing/robot_files.h"
#include "testing/sampled_links.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr double kStep = 0.005;      // s, of the simulation
constexpr int kEndsPerState = 1000;  // poses that stops may end in
constexpr int kStatesWithEnds = 50;  // enough to tell how tight boxes are
constexpr double kNearFace = 1e-12;  // m; nearer, double is not precise enough
constexpr int kMaxChecks = 20;       // in quadruple precision, per state

/// How a simulated joint may differ from what it declares: its braking distance is so much longer.
struct Brakes {
  double longer = 1;
};

/// One joint on its way to standstill: random within what it declares.
class Stop {
 public:
  Stop(double speed, const Braking& braking, const Reaction& reaction, Random& random)
      : speed_(speed), braking_(braking), reaction_(reaction), random_(random) {}

  double offset() const { return offset_; }
  bool stands() const { return time_ >= reaction_.time && speed_ == 0; }

  /// Until the reaction ends it keeps its speed, or it speeds up or slows down at random. Then it
  /// brakes, often no harder than it must.
  void step(const Brakes& brakes) {
    const double rest = reaction_.time - time_;
    const double time = rest > 0 ? std::min(rest, kStep) : kStep;
    time_ = rest > 0 && rest <= kStep ? reaction_.time : time_ + time;
    const double before = speed_;
    if (rest > 0) {
      if (reaction_.may_speed_up) speedUp(time);
      offset_ += reaction_.may_speed_up ? (before + speed_) / 2 * time : before * time;
      return;
    }
    const double harder = random_.sign() > 0 ? 1 : random_.uniform(1, 3);
    const double fall = braking_.deceleration * harder / brakes.longer;
    const double end = std::max(0.0, std::abs(before) - fall * time);
    const double path = (before * before - end * end) / (2 * fall);
    offset_ += before > 0 ? path : -path;
    speed_ = before > 0 ? end : -end;
  }

 private:
  void speedUp(double time) {
    const double top = std::max(std::abs(speed_), *braking_.max_speed);
    const double change = *braking_.acceleration * time * random_.uniform(-1, 1.5);
    const double most = *braking_.acceleration * time;
    speed_ = std::min(std::max(speed_ + std::min(std::max(change, -most), most), -top), top);
  }

  double speed_;
  const Braking& braking_;
  const Reaction& reaction_;
  Random& random_;
  double time_ = 0;
  double offset_ = 0;
};

struct Model {
  Robot robot;
  BoundedRobot bounded;
};

/// What a stop of a robot starts from.
struct Start {
  std::vector<double> values;
  std::vector<double> speeds;
  std::vector<Braking> braking;
  Reaction reaction{0.1, false};
};

bool canMove(const Joint& joint) {
  return hasValue(joint.motion) && !joint.axis.isZero(0);
}

Start randomStart(const Robot& robot, Random& random) {
  Start start;
  start.reaction = {random.uniform(0, 0.2), random.sign() > 0};
  for (const Joint& joint : robot.joints) {
    const Limits limits = joint.limits.value_or(Limits{-3, 3});
    start.values.push_back(canMove(joint) ? random.uniform(limits.lower, limits.upper) : 0);
    const double top = joint.motion == Motion::kTranslation ? 0.3 : 1.5;
    start.speeds.push_back(canMove(joint) ? random.uniform(-top, top) : 0);
    start.braking.push_back({random.uniform(2, 8), random.uniform(1, 6), top});
  }
  return start;
}

Limits offsetsOf(const Start& start, std::size_t joint) {
  const double speed = start.speeds[joint];
  return stopOffsets({speed, speed}, start.braking[joint], start.reaction);
}

/// The joints above a link, placed where they are at the start.
std::vector<MovingJoint> movingJoints(const Robot& robot, const Start& start,
                                      const std::vector<Eigen::Isometry3d>& poses,
                                      std::size_t link) {
  std::vector<MovingJoint> result;
  const std::vector<std::size_t> above = jointsAbove(robot, link);
  for (auto index = above.rbegin(); index != above.rend(); ++index) {
    const Joint& joint = robot.joints[*index];
    if (!canMove(joint)) continue;
    const Eigen::Isometry3d& pose = poses[joint.child];
    const bool turns = joint.motion == Motion::kRotation;
    result.push_back({turns ? MovingJoint::Kind::kTurn : MovingJoint::Kind::kSlide,
                      pose.translation(), pose.linear() * joint.axis, offsetsOf(start, *index)});
  }
  return result;
}

double faceGap(const Aabb& outer, const Aabb& inner, int face) {
  return face < 3 ? inner.min()[face] - outer.min()[face]
                  : outer.max()[face - 3] - inner.max()[face - 3];
}

/// What many stops of one robot told.
struct Findings {
  double nearest = std::numeric_limits<double>::infinity();  ///< of any box to its face [m]
  std::vector<double> looseness;  ///< of faces, beyond 10 % of how far the sampled face moved [m]
  std::size_t poses = 0;          ///< that were looked at, of all links
  std::size_t near_faces = 0;     ///< of these, those that were checked in quadruple precision
  std::size_t outside = 0;        ///< of these
  int states = 0;
  double seconds = 0;  ///< for all boxes of all stops
  std::size_t boxes = 0;

  double median() {
    std::sort(looseness.begin(), looseness.end());
    return looseness[looseness.size() / 2];
  }
};

/// Whether the link at these values is inside, padding left out.
bool isInside(const Model& model, std::size_t index, const std::vector<double>& values,
              const Aabb& bounds) {
  const Robot& robot = model.robot;
  const std::vector<std::size_t> above = jointsAbove(robot, model.bounded.indices[index]);
  QuadPose pose = quadPose(Eigen::Affine3d::Identity());
  for (auto joint = above.rbegin(); joint != above.rend(); ++joint) {
    pose = pose * quadPose(Eigen::Affine3d(robot.joints[*joint].parent_from_joint)) *
           quadJointMotion(robot.joints[*joint], values[*joint]);
  }
  return contains(bounds, quadBox(model.bounded.links[index], pose));
}

/// One state of the robot, and some stops from there.
void tryState(const Model& model, const Brakes& brakes, int stops, Random& random,
              Findings& findings) {
  const Robot& robot = model.robot;
  const Start start = randomStart(robot, random);
  const auto poses = linkPoses(robot, start.values);
  const std::size_t count = model.bounded.links.size();
  std::vector<std::optional<Aabb>> bounds;
  std::vector<Aabb> attained(count);
  const std::clock_t begin = std::clock();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t link = model.bounded.indices[k];
    bounds.push_back(boxOfMoving(model.bounded.links[k], Eigen::Affine3d(poses[link]),
                                 movingJoints(robot, start, poses, link)));
  }
  findings.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  int checks = 0;
  const auto look = [&](const std::vector<double>& values) {
    const auto now = linkPoses(robot, values);
    for (std::size_t k = 0; k < count; ++k) {
      const auto box =
          linkBox(model.bounded.links[k], Eigen::Affine3d(now[model.bounded.indices[k]]));
      ASSERT_EQ(bounds[k].has_value(), box.has_value()) << model.bounded.links[k].name;
      if (!box) continue;
      attained[k].extend(*box);
      ++findings.poses;
      double gap = std::numeric_limits<double>::infinity();
      for (int face = 0; face < 6; ++face)
        gap = std::min(gap, faceGap(*bounds[k], *box, face));
      findings.nearest = std::min(findings.nearest, gap);
      const bool moves = random.uniform(0, 1) < 0.1;  // not the same links again and again
      if (gap > kNearFace || !moves || checks >= kMaxChecks) continue;
      ++checks;
      ++findings.near_faces;
      findings.outside += !isInside(model, k, values, *bounds[k]);
    }
  };
  look(start.values);
  const std::vector<Aabb> first = attained;
  for (int i = 0; i < stops; ++i) {
    std::vector<Stop> moving;
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      moving.emplace_back(start.speeds[j], start.braking[j], start.reaction, random);
    for (bool stands = false; !stands;) {
      std::vector<double> values = start.values;
      stands = true;
      for (std::size_t j = 0; j < moving.size(); ++j) {
        moving[j].step(brakes);
        values[j] += moving[j].offset();
        stands = stands && moving[j].stands();
      }
      look(values);
    }
  }
  // Each joint may be anywhere in its interval, often at an end, where many extremes are.
  const bool tries_ends = brakes.longer == 1 && findings.states++ < kStatesWithEnds;
  for (int i = 0; tries_ends && i < kEndsPerState; ++i) {
    std::vector<double> values = start.values;
    for (std::size_t j = 0; j < values.size(); ++j) {
      const auto [lower, upper] = offsetsOf(start, j);
      const double part = std::min(std::max(random.uniform(-0.5, 1.5), 0.0), 1.0);
      if (canMove(robot.joints[j])) values[j] += lower + part * (upper - lower);
    }
    look(values);
  }
  for (std::size_t k = 0; k < count; ++k) {
    for (int face = 0; tries_ends && bounds[k] && face < 6; ++face) {
      const double moved = faceGap(attained[k], first[k], face);
      findings.looseness.push_back(faceGap(*bounds[k], attained[k], face) - moved / 10);
    }
  }
  findings.boxes += count;
}

Findings trySome(const Model& model, const Brakes& brakes, int states, int stops) {
  Random random(31);
  Findings findings;
  for (int i = 0; i < states; ++i)
    tryState(model, brakes, stops, random, findings);
  return findings;
}

void report(const std::string& name, int stops, Findings& findings) {
  std::cout << name << ": " << stops << " stops, a box came within " << findings.nearest
            << " m of a face; faces are at most 10 % of their way and " << findings.median()
            << " m (median), " << findings.looseness.back() << " m (worst) too far out; "
            << findings.near_faces << " of " << findings.poses
            << " boxes checked in quadruple precision, outside " << findings.outside << "; "
            << findings.seconds / static_cast<double>(findings.boxes) * 1e6 << " us per link\n";
}

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Assimp serves one thread at a time.
TriangleMesh importAlone(const MeshFile& mesh) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return importMesh(mesh);
}

Model load(const std::filesystem::path& file, const PackagePath& package_path) {
  Model model;
  model.robot = parseRobot(textOf(file));
  model.bounded = RobotLoader(importAlone).load(model.robot, {}, {package_path, ""});
  return model;
}

Model demoRobot() {
  const auto demo = std::filesystem::canonical("../launch/demo/demo.urdf");
  const std::filesystem::path package = demo.parent_path().parent_path().parent_path();
  return load(demo, [&package](const std::string&) { return package.string(); });
}

int samples() {
  const char* const text = std::getenv("LINK_BOUNDS_TEST_SAMPLES");
  return text ? std::atoi(text) : repetitions(40);
}

constexpr int kStopsPerState = 10;

TEST(MovingLink, StopsOfTheDemoRobotStayInside) {
  const Model model = demoRobot();
  Findings findings = trySome(model, {}, samples(), kStopsPerState);
  EXPECT_GE(findings.nearest, 0);
  EXPECT_EQ(findings.outside, 0u);
  EXPECT_GT(findings.near_faces, 0u);
  EXPECT_LE(findings.median(), 0.005);
  report("demo", samples() * kStopsPerState, findings);
}

/// What is not as declared is not covered: else the boxes would be too large to tell anything.
TEST(MovingLink, LongerBrakingLeavesTheBoxes) {
  constexpr int kStates = 40;  // with fewer, none comes far enough
  EXPECT_LT(trySome(demoRobot(), {1.1}, kStates, kStopsPerState).nearest, 0);
}

TEST(MovingLink, StopsOfPublicRobotsStayInside) {
  const char* data = std::getenv("LINK_BOUNDS_DATA");
  if (!data) GTEST_SKIP() << "skipped: stops of public robots: LINK_BOUNDS_DATA is not set";
  const std::filesystem::path robots = std::filesystem::path(data) / "robots";
  const PackagePath package_path = [&](const std::string& package) {
    return (robots / package).string();
  };
  const char* const only = std::getenv("LINK_BOUNDS_TEST_ROBOT");
  for (const std::filesystem::path& file : robotFiles(robots)) {
    if (only && file.stem() != only) continue;
    const bool is_long = samples() >= 1000;
    const int stops = is_long ? 20 : 2;
    const int states = (is_long ? samples() : samples() / 5) / stops + 1;
    Findings findings = trySome(load(file, package_path), {}, states, stops);
    EXPECT_GE(findings.nearest, 0) << file;
    EXPECT_EQ(findings.outside, 0u) << file;
    EXPECT_LE(findings.median(), 0.005) << file;
    report(file.stem().string(), states * stops, findings);
  }
}

/// Links of all shapes, behind joints of any width up to more than a turn.
TEST(MovingLink, RandomMotionsStayInside) {
  Random random(5);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions(300); ++i) {
    const BoundedLink link = randomLink(random);
    const Eigen::Affine3d pose(random.rigid(random.magnitude(-1, 5)).matrix());
    std::vector<MovingJoint> joints;
    const double widest = random.magnitude(-4, 1);
    for (int k = static_cast<int>(random.uniform(0, 9)); k > 0; --k) {
      MovingJoint joint{static_cast<MovingJoint::Kind>(static_cast<int>(random.uniform(0, 3))),
                        pose.translation() + random.vector(1), random.vector(1).normalized()};
      joint.offsets = {-random.uniform(0, widest), random.uniform(0, widest)};
      joint.distance = random.uniform(0, widest);
      joint.spread = random.uniform(0, 1);
      joint.turn = random.uniform(0, widest);
      joints.push_back(joint);
    }
    const auto bounds = boxOfMoving(link, pose, joints);
    ASSERT_TRUE(bounds);
    for (int k = 0; k < 30; ++k) {
      Eigen::Affine3d moved = Eigen::Affine3d::Identity();
      for (const MovingJoint& joint : joints) {
        const double part = std::min(std::max(random.uniform(-0.5, 1.5), 0.0), 1.0);
        const double offset =
            joint.offsets.lower + part * (joint.offsets.upper - joint.offsets.lower);
        const Eigen::Translation3d at(joint.origin);
        if (joint.kind == MovingJoint::Kind::kTurn) {
          moved = moved * at * Eigen::AngleAxisd(offset, joint.axis) * at.inverse();
        } else if (joint.kind == MovingJoint::Kind::kSlide) {
          moved = moved * Eigen::Translation3d(offset * joint.axis);
        } else {
          const Eigen::Vector3d across = joint.axis.cross(random.vector(1)).normalized();
          const Eigen::AngleAxisd deviation(part * joint.spread, across);
          const Eigen::Vector3d path = joint.distance * part * (deviation * joint.axis);
          const Eigen::AngleAxisd turn(part * joint.turn, random.vector(1).normalized());
          moved = moved * Eigen::Translation3d(path) * at * turn * at.inverse();
        }
      }
      const Aabb box = *linkBox(link, moved * pose);
      for (int face = 0; face < 6; ++face)
        nearest = std::min(nearest, faceGap(*bounds, box, face));
    }
  }
  EXPECT_GE(nearest, 0);
}

TEST(StopOffsets, AreTheFormulasOfTheHeader) {
  const auto near = [](const Limits& offsets, double lower, double upper) {
    EXPECT_NEAR(offsets.lower, lower, 1e-12);
    EXPECT_NEAR(offsets.upper, upper, 1e-12);
  };
  const Braking plain{2, {}, 3};
  near(stopOffsets({0, 0}, plain, {0.5, false}), 0, 0);
  near(stopOffsets({1, 2}, plain, {0.5, false}), 0, 2 * 0.5 + 4.0 / 4);
  near(stopOffsets({-2, 1}, plain, {0.5, false}), -2, 0.5 + 1.0 / 4);
  near(stopOffsets({0, 0}, plain, {0.5, true}), -1.5 - 9.0 / 4, 1.5 + 9.0 / 4);
  const Braking slow{2, 4, 3};
  near(stopOffsets({1, 1}, slow, {0.25, true}), -0.125 - 1.0 / 4, 0.25 + 0.125 + 4.0 / 4);
  EXPECT_NEAR(stopOffsets({1, 1}, slow, {1, true}).upper, 2 * 0.5 + 3 * 0.5 + 9.0 / 4, 1e-12);
  near(stopOffsets({5, 5}, slow, {0.1, true}), -0.02 - 0.16 / 4, 0.5 + 25.0 / 4);
}

TEST(JointFit, FindsTheValueOfEachType) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    Joint joint;
    joint.motion = i % 2 == 0 ? Motion::kRotation : Motion::kTranslation;
    joint.parent_from_joint = Eigen::Isometry3d(random.rigid(1).matrix());
    joint.axis = random.vector(1).normalized();
    const double value = random.uniform(-10, 10);
    const Eigen::Isometry3d pose = joint.parent_from_joint * jointMotion(joint, value);
    const JointFit fit = fitOf(joint, pose);
    const bool turns = joint.motion == Motion::kRotation;
    EXPECT_NEAR(turns ? withoutTurns(fit.value - value) : fit.value - value, 0, 1e-12);
    EXPECT_LT(fit.length_error + fit.angle_error, 1e-12);
    Eigen::Isometry3d off = pose;
    off.translation() += 0.002 * joint.parent_from_joint.linear() * joint.axis.unitOrthogonal();
    EXPECT_NEAR(fitOf(joint, off).length_error, 0.002, 1e-9);
    off = pose * Eigen::AngleAxisd(0.002, joint.axis.unitOrthogonal());
    EXPECT_NEAR(fitOf(joint, off).angle_error, 0.002, 1e-9);
  }
}

}  // namespace
}  // namespace link_bounds
