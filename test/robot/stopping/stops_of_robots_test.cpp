// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No pose on the way to a stop leaves the box of the stop. Poses that come near a face are checked
// in quadruple precision; a link is looked at again once it may have come to a face.
// LINK_BOUNDS_TEST_SAMPLES: how many stops of each robot. LINK_BOUNDS_TEST_ROBOT: only this robot
// of LINK_BOUNDS_DATA.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>

#include "testing/import_alone.h"
#include "testing/quad_poses.h"
#include "testing/robot_files.h"
#include "testing/sampled_links.h"
#include "testing/sanitized.h"
#include "testing/simulated_stop.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr int kEndsPerState = 100;   // random poses that stops may end in
constexpr int kStatesWithEnds = 50;  // enough to tell how tight boxes are
constexpr double kNearFace = 1e-10;  // m; much farther than double is wrong
constexpr int kMaxChecks = 3;        // in quadruple precision, per link and state

struct Model : LoadedRobot {
  /// By link with shapes and by joint: how far the joint moves a point of the link at most, per
  /// radian or metre [m].
  std::vector<std::vector<double>> levers = {};
  /// By link with shapes and by shape.
  std::vector<std::vector<std::vector<Eigen::Vector3d>>> points = {};
};

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

TEST(StopsOfRobots, StopsOfTheDemoRobotStayInside) {
  const Model model = load(demoRobotFile());
  Findings findings = trySome(model, {}, samples(), kStopsPerState);
  EXPECT_GE(findings.nearest, 0);
  EXPECT_EQ(findings.outside, 0u);
  EXPECT_GT(findings.near_faces, 0u);
  EXPECT_LE(findings.median(), kLooseness);
  report("demo", samples() * kStopsPerState, findings);
}

/// Robots that brake worse than declared leave the boxes: these are no larger than they must be.
/// And looking at links only where needed misses no pose outside.
TEST(StopsOfRobots, LongerBrakingLeavesTheBoxes) {
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

TEST(StopsOfRobots, StopsOfPublicRobotsStayInside) {
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

}  // namespace
}  // namespace link_bounds
