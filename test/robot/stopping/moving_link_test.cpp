// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No pose on the way to a stop leaves the box of the stop. Poses that come near a face are checked
// in quadruple precision; a link is looked at again once it may have come to a face.
// LINK_BOUNDS_TEST_SAMPLES: how many stops of each robot. LINK_BOUNDS_TEST_ROBOT: only this robot of
// LINK_BOUNDS_DATA.
#include "robot/stopping/moving_link.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/stopping/joint_fit.h"
#include "robot/stopping/stop_offsets.h"
#include "robot/urdf/joints_above.h"
#include "testing/brute_force.h"
#include "testing/import_alone.h"
#include "testing/quad_poses.h"
#include "testing/robot_files.h"
#include "testing/sampled_links.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr double kStep = 0.005;      // s, of the simulation
constexpr int kEndsPerState = 100;   // random poses that stops may end in
constexpr int kStatesWithEnds = 50;  // enough to tell how tight boxes are
constexpr double kNearFace = 1e-10;  // m; much farther than double is wrong
constexpr int kMaxChecks = 3;        // in quadruple precision, per link and state

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

struct Model : LoadedRobot {
  /// By link with shapes and by joint: how far the joint moves a point of the link at most, per
  /// radian or metre [m].
  std::vector<std::vector<double>> levers = {};
  /// By link with shapes and by shape.
  std::vector<std::vector<std::vector<Eigen::Vector3d>>> points = {};
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

Limits limitsOf(const Joint& joint) {
  return joint.limits.value_or(Limits{-3, 3});
}

/// How far a prismatic joint may be from zero, also while it stops beyond its limits [m].
double farthestSlide(const Joint& joint) {
  constexpr double kStop = 1;  // a stop from the speeds of randomStart() takes less
  const Limits limits = limitsOf(joint);
  return std::max(std::abs(limits.lower), std::abs(limits.upper)) + kStop;
}

/// Along the chain, as if it were stretched.
std::vector<double> leversOf(const Robot& robot, const BoundedLink& link, std::size_t index) {
  std::vector<double> result(robot.joints.size(), 0);
  double length = std::sqrt(3) * magnitude(link);
  for (const std::size_t above : jointsAbove(robot, index)) {
    const Joint& joint = robot.joints[above];
    const bool slides = joint.motion == Motion::kTranslation;
    if (canMove(joint)) result[above] = slides ? 1 : length;
    length += joint.parent_from_joint.translation().norm() + (slides ? farthestSlide(joint) : 0);
  }
  return result;
}

Start randomStart(const Robot& robot, Random& random) {
  Start start;
  start.reaction = {random.uniform(0, 0.2), random.sign() > 0};
  for (const Joint& joint : robot.joints) {
    const Limits limits = limitsOf(joint);
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
  std::size_t poses = 0;          ///< of all links
  std::size_t looked_at = 0;      ///< of these; the others cannot have come to a face
  std::size_t beyond = 0;         ///< of these, in double precision
  std::size_t near_faces = 0;     ///< those that were checked in quadruple precision
  std::size_t outside = 0;        ///< of these
  double seconds = 0;             ///< for all boxes of all stops
  std::size_t boxes = 0;

  double median() {
    std::sort(looseness.begin(), looseness.end());
    return looseness[looseness.size() / 2];
  }
};

constexpr double kLooseness = 0.002;        // m, median of each robot
constexpr double kLargestLooseness = 0.12;  // m

/// Of the points of a shape, those that may be extreme along an axis: in double precision no other
/// one is farther by more than a margin that its rounding does not come near.
std::vector<Eigen::Vector3d> nearlyExtreme(const std::vector<Eigen::Vector3d>& points,
                                           const QuadPose& placed) {
  constexpr double kMargin = 1e-9;  // m
  std::vector<Eigen::Vector3d> result;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d row = placed.linear.row(k).cast<double>();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector3d& point : points) {
      low = std::min(low, row.dot(point));
      high = std::max(high, row.dot(point));
    }
    for (const Eigen::Vector3d& point : points) {
      const double coordinate = row.dot(point);
      if (coordinate <= low + kMargin || coordinate >= high - kMargin) result.push_back(point);
    }
  }
  return result;
}

/// Whether the link at these values is inside, padding left out.
bool isInside(const Model& model, std::size_t index, const std::vector<double>& values,
              const Aabb& bounds) {
  const Robot& robot = model.robot;
  const std::vector<std::size_t> above = jointsAbove(robot, model.bounded.indices[index]);
  QuadPose pose;
  for (auto joint = above.rbegin(); joint != above.rend(); ++joint) {
    pose = pose * toQuad(robot.joints[*joint].parent_from_joint) *
           quadMotion(robot.joints[*joint], values[*joint]);
  }
  QuadBox box = emptyQuadBox();
  const std::vector<Shape>& shapes = model.bounded.links[index].shapes;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const QuadPose placed = pose * toQuad(shapes[i].link_from_shape);
    extend(box, shapes[i], placed, nearlyExtreme(model.points[index][i], placed));
  }
  return contains(bounds, box);
}

/// Which poses of a stop are looked at.
enum class Looks {
  kAll,
  kWhereNeeded  ///< those of a link that may have come to a face since it was looked at
};

/// One state of a robot, and stops from there.
class Trial {
 public:
  Trial(const Model& model, Random& random, Findings& findings);

  void tryStop(const Brakes& brakes, Looks looks);

  /// Each joint may be anywhere in its interval: at random, often at an end, where many extremes
  /// are, and as far as it brings each face of each link.
  void tryEnds();

 private:
  void findBounds();
  void moveTo(const std::vector<double>& values, Looks looks);
  void look();
  void judge(std::size_t link, const Aabb& box);
  double valueAt(std::size_t joint, double part) const;
  void climb(std::size_t link, int face);

  const Model& model_;
  const Robot& robot_;
  const std::vector<BoundedLink>& links_;
  Random& random_;
  Findings& findings_;
  Start start_;
  std::vector<bool> can_move_;               ///< by link
  std::vector<std::size_t> moving_;          ///< joints
  std::vector<std::optional<Aabb>> bounds_;  ///< by link, as what follows
  std::vector<Aabb> attained_;
  std::vector<Aabb> first_;       ///< boxes at the start
  std::vector<double> gaps_;      ///< when it was looked at
  std::vector<double> ways_;      ///< how far its points may have come since then [m]
  std::vector<double> at_start_;  ///< gaps_
  std::vector<int> checks_;       ///< in quadruple precision
  std::vector<double> values_;    ///< by joint
  std::vector<std::size_t> due_;  ///< links to look at
};

Trial::Trial(const Model& model, Random& random, Findings& findings)
    : model_(model),
      robot_(model.robot),
      links_(model.bounded.links),
      random_(random),
      findings_(findings),
      start_(randomStart(robot_, random)),
      attained_(links_.size()),
      gaps_(links_.size()),
      ways_(links_.size()),
      checks_(links_.size()),
      values_(start_.values) {
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    if (canMove(robot_.joints[j])) moving_.push_back(j);
  }
  for (std::size_t k = 0; k < links_.size(); ++k) {
    can_move_.push_back(std::any_of(moving_.begin(), moving_.end(),
                                    [&](std::size_t j) { return model.levers[k][j] > 0; }));
  }
  findBounds();
  moveTo(start_.values, Looks::kAll);
  first_ = attained_;
  at_start_ = gaps_;
}

void Trial::findBounds() {
  const auto poses = linkPoses(robot_, start_.values);
  const std::clock_t begin = std::clock();
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const std::size_t link = model_.bounded.indices[k];
    bounds_.push_back(boxOfMoving(links_[k], Eigen::Affine3d(poses[link]),
                                  movingJoints(robot_, start_, poses, link)));
  }
  findings_.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  findings_.boxes += links_.size();
}

/// No point of a link moves farther than the joints' ways times their levers. So while that is less
/// than the gap which the link had, it is inside.
void Trial::moveTo(const std::vector<double>& values, Looks looks) {
  constexpr double kRoundings = 1e-9;  // m, and all that is near a face is looked at
  due_.clear();
  for (std::size_t k = 0; k < links_.size(); ++k) {
    for (const std::size_t j : moving_)
      ways_[k] += model_.levers[k][j] * std::abs(values[j] - values_[j]);
    if (looks == Looks::kAll || (can_move_[k] && ways_[k] + kRoundings >= gaps_[k]))
      due_.push_back(k);
  }
  values_ = values;
  findings_.poses += links_.size();
  if (!due_.empty()) look();
}

void Trial::look() {
  const auto poses = linkPoses(robot_, values_);
  for (const std::size_t k : due_) {
    const auto box = linkBox(links_[k], Eigen::Affine3d(poses[model_.bounded.indices[k]]));
    EXPECT_EQ(bounds_[k].has_value(), box.has_value()) << links_[k].name;
    gaps_[k] = std::numeric_limits<double>::infinity();
    ways_[k] = 0;
    if (box && bounds_[k]) judge(k, *box);
  }
}

void Trial::judge(std::size_t link, const Aabb& box) {
  attained_[link].extend(box);
  ++findings_.looked_at;
  double& gap = gaps_[link];
  for (int face = 0; face < 6; ++face)
    gap = std::min(gap, faceGap(*bounds_[link], box, face));
  findings_.nearest = std::min(findings_.nearest, gap);
  findings_.beyond += gap < 0;
  if (gap > kNearFace || !can_move_[link] || checks_[link] >= kMaxChecks) return;
  ++checks_[link];
  ++findings_.near_faces;
  findings_.outside += !isInside(model_, link, values_, *bounds_[link]);
}

void Trial::tryStop(const Brakes& brakes, Looks looks) {
  std::vector<Stop> stops;
  for (const std::size_t j : moving_)
    stops.emplace_back(start_.speeds[j], start_.braking[j], start_.reaction, random_);
  values_ = start_.values;
  gaps_ = at_start_;
  std::fill(ways_.begin(), ways_.end(), 0);
  std::vector<double> values = start_.values;
  for (bool stands = false; !stands;) {
    stands = true;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      stops[i].step(brakes);
      values[moving_[i]] = start_.values[moving_[i]] + stops[i].offset();
      stands = stands && stops[i].stands();
    }
    moveTo(values, looks);
  }
}

/// 0: the lower end of the joint's interval, 1: the upper one.
double Trial::valueAt(std::size_t joint, double part) const {
  const auto [lower, upper] = offsetsOf(start_, joint);
  return start_.values[joint] + lower + part * (upper - lower);
}

/// Joint by joint to where the face is farthest out, again and again.
void Trial::climb(std::size_t link, int face) {
  constexpr int kPasses = 2;
  constexpr double kParts[] = {0, 0.25, 0.5, 0.75, 1};
  std::vector<double> values = start_.values;
  for (int i = 0; i < kPasses; ++i) {
    for (const std::size_t j : moving_) {
      if (model_.levers[link][j] == 0) continue;
      double best = values[j];
      double smallest = std::numeric_limits<double>::infinity();
      for (const double part : kParts) {
        values[j] = valueAt(j, part);
        const auto poses = linkPoses(robot_, values);
        const Eigen::Affine3d pose(poses[model_.bounded.indices[link]]);
        const double gap = faceGap(*bounds_[link], *linkBox(links_[link], pose), face);
        if (gap >= smallest) continue;
        smallest = gap;
        best = values[j];
      }
      values[j] = best;
    }
  }
  moveTo(values, Looks::kAll);
}

void Trial::tryEnds() {
  for (int i = 0; i < kEndsPerState; ++i) {
    std::vector<double> values = start_.values;
    for (const std::size_t j : moving_)
      values[j] = valueAt(j, std::min(std::max(random_.uniform(-0.5, 1.5), 0.0), 1.0));
    moveTo(values, Looks::kAll);
  }
  for (std::size_t k = 0; k < links_.size(); ++k) {
    for (int face = 0; bounds_[k] && can_move_[k] && face < 6; ++face)
      climb(k, face);
  }
  for (std::size_t k = 0; k < links_.size(); ++k) {
    for (int face = 0; bounds_[k] && can_move_[k] && face < 6; ++face) {
      const double moved = faceGap(attained_[k], first_[k], face);
      findings_.looseness.push_back(faceGap(*bounds_[k], attained_[k], face) - moved / 10);
    }
  }
}

Findings trySome(const Model& model, const Brakes& brakes, int states, int stops,
                 Looks looks = Looks::kWhereNeeded) {
  Random random(31);
  Findings findings;
  for (int i = 0; i < states; ++i) {
    Trial trial(model, random, findings);
    const bool tries_ends = brakes.longer == 1 && i < kStatesWithEnds;
    for (int k = 0; k < stops; ++k)
      trial.tryStop(brakes, tries_ends ? Looks::kAll : looks);
    if (tries_ends) trial.tryEnds();
  }
  return findings;
}

void report(const std::string& name, int stops, Findings& findings) {
  std::cout << name << ": " << stops << " stops, a box came within " << findings.nearest
            << " m of a face; faces are at most 10 % of their way and " << findings.median()
            << " m (median), " << findings.looseness.back() << " m (worst) too far out; "
            << findings.looked_at << " of " << findings.poses
            << " boxes looked at, as the others cannot have come to a face; outside "
            << findings.beyond << "; " << findings.near_faces
            << " checked in quadruple precision, outside " << findings.outside << "; "
            << findings.seconds / static_cast<double>(findings.boxes) * 1e6 << " us per link\n";
}

Model load(const RobotFile& file) {
  Model model{loadedAlone(parseRobot(textOf(file.urdf)), file.package_path)};
  for (std::size_t i = 0; i < model.bounded.links.size(); ++i) {
    const BoundedLink& link = model.bounded.links[i];
    model.levers.push_back(leversOf(model.robot, link, model.bounded.indices[i]));
    model.points.emplace_back();
    for (const Shape& shape : link.shapes)
      model.points.back().push_back(centersOf(shape));
  }
  return model;
}

int samples() {
  const char* const text = std::getenv("LINK_BOUNDS_TEST_SAMPLES");
  return text ? std::atoi(text) : repetitions(40);
}

constexpr int kStopsPerState = 10;

TEST(MovingLink, StopsOfTheDemoRobotStayInside) {
  const Model model = load(demoRobotFile());
  Findings findings = trySome(model, {}, samples(), kStopsPerState);
  EXPECT_GE(findings.nearest, 0);
  EXPECT_EQ(findings.outside, 0u);
  EXPECT_GT(findings.near_faces, 0u);
  EXPECT_LE(findings.median(), kLooseness);
  report("demo", samples() * kStopsPerState, findings);
}

/// Robots that brake worse than declared leave the boxes: these are no larger than they must be. And
/// looking at links only where needed misses no pose outside.
TEST(MovingLink, LongerBrakingLeavesTheBoxes) {
  constexpr int kStates = 40;  // with fewer, none comes far enough
  const Model model = load(demoRobotFile());
  const Findings all = trySome(model, {1.1}, kStates, kStopsPerState, Looks::kAll);
  const Findings some = trySome(model, {1.1}, kStates, kStopsPerState);
  EXPECT_LT(some.nearest, 0);
  EXPECT_GT(some.beyond, 0u);
  EXPECT_EQ(some.beyond, all.beyond);
  EXPECT_EQ(some.nearest, all.nearest);
  EXPECT_EQ(some.poses, all.looked_at);
  EXPECT_LT(some.looked_at, all.looked_at / 2);
}

TEST(MovingLink, StopsOfPublicRobotsStayInside) {
  const std::vector<RobotFile> files = publicRobotFiles();
  if (files.empty()) GTEST_SKIP() << "skipped: stops of public robots: LINK_BOUNDS_DATA is not set";
  const char* const only = std::getenv("LINK_BOUNDS_TEST_ROBOT");
  int robots_tried = 0;
  for (const RobotFile& file : files) {
    if (only && file.name() != only) continue;
    const bool is_long = samples() >= 1000;
    const int stops = is_long ? 20 : 2;
    const int states = (is_long ? samples() : samples() / 5) / stops + 1;
    Findings findings = trySome(load(file), {}, states, stops);
    EXPECT_GE(findings.nearest, 0) << file.urdf;
    EXPECT_EQ(findings.beyond + findings.outside, 0u) << file.urdf;
    EXPECT_LE(findings.median(), kLooseness) << file.urdf;
    EXPECT_LE(findings.looseness.back(), kLargestLooseness) << file.urdf;
    report(file.name(), states * stops, findings);
    ++robots_tried;
  }
  EXPECT_GT(robots_tried, 0);
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

/// Poses of a link at random offsets, at the ends of all joints, and where single offsets bring the
/// face farther out, again and again.
Aabb attainedBox(const BoundedLink& link, const Eigen::Affine3d& pose,
                 const std::vector<MovingJoint>& joints) {
  const auto boxAt = [&](const std::vector<double>& parts) {
    Eigen::Affine3d moved = Eigen::Affine3d::Identity();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const auto [lower, upper] = joints[i].offsets;
      const Eigen::Translation3d at(joints[i].origin);
      moved = moved * at * Eigen::AngleAxisd(lower + parts[i] * (upper - lower), joints[i].axis) *
              at.inverse();
    }
    return *linkBox(link, moved * pose);
  };
  constexpr int kPasses = 4;
  constexpr int kParts = 16;
  Aabb attained = boxAt(std::vector<double>(joints.size(), 0.5));
  for (int face = 0; face < 6; ++face) {
    std::vector<double> parts(joints.size(), 0.5);
    for (std::size_t step = 0; step < kPasses * joints.size(); ++step) {
      double& part = parts[step % joints.size()];
      double best = part, smallest = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= kParts; ++k) {
        part = static_cast<double>(k) / kParts;
        const double gap = faceGap(attained, boxAt(parts), face);
        if (gap >= smallest) continue;
        smallest = gap;
        best = part;
      }
      part = best;
      attained.extend(boxAt(parts));
    }
  }
  return attained;
}

/// As a finger far from the joints of an arm: more joints than can be examined at several angles.
TEST(MovingLink, TurnsOfPointsAreNearlyExact) {
  constexpr double kShare = 0.05;   // of how far the face moved
  constexpr double kLength = 2e-3;  // m
  Random random(17);
  double worst = 0;
  for (int i = 0; i < repetitions(20); ++i) {
    Shape shape;
    shape.points = std::make_shared<const PointSet>(std::vector<Eigen::Vector3f>{{0, 0, 0}});
    const BoundedLink link = linkOf({shape});
    const Eigen::Affine3d pose(random.rigid(1).matrix());
    std::vector<MovingJoint> joints;
    for (int k = 0; k < 12; ++k) {
      MovingJoint joint{MovingJoint::Kind::kTurn,
                        pose.translation() + random.uniform(0.5, 1) * random.vector(1).normalized(),
                        random.vector(1).normalized()};
      joint.offsets = {-random.uniform(0, 0.02), random.uniform(0, 0.02)};
      joints.push_back(joint);
    }
    const auto bounds = boxOfMoving(link, pose, joints);
    ASSERT_TRUE(bounds);
    const Aabb start = *linkBox(link, pose);
    const Aabb attained = attainedBox(link, pose, joints);
    for (int face = 0; face < 6; ++face) {
      const double gap = faceGap(*bounds, attained, face);
      EXPECT_GE(gap, 0);
      worst = std::max(worst, gap - kShare * faceGap(attained, start, face));
    }
  }
  EXPECT_LE(worst, kLength);
  std::cout << "at most " << kShare << " of the way and " << worst << " m too far out\n";
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
