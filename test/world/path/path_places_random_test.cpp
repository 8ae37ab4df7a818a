// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random drives of a robot among objects whose frames tf tells at other rates: where a path begins,
// each body is where the last transforms have it, beside a list of poses.
#include <gtest/gtest.h>

#include <random>

#include "testing/live_objects_testing.h"
#include "testing/moving_robot.h"
#include "world/path/path_scene.h"

namespace link_bounds {
namespace {

constexpr int kSequences = 100;
constexpr int kSteps = 100;
constexpr int kObjects = 6;

/// An arm turns on a base, and a tool on the arm; beside them a camera. Nothing touches, so pairs
/// are of no interest.
constexpr char kDrivingArm[] = R"(<robot name="arm">
  <link name="base"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
  <link name="arm"><visual><geometry><box size="0.7 0.1 0.1"/></geometry></visual></link>
  <link name="tool"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="roll" type="revolute"><parent link="arm"/><child link="tool"/>
    <origin xyz="1 0 0"/><axis xyz="1 0 0"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <link name="pan"/>
  <joint name="look" type="continuous"><parent link="base"/><child link="pan"/>
    <axis xyz="0 0 1"/></joint>
</robot>)";

/// Of a frame beside the links: its parent, and where it was in that when it was sent last.
struct SeldomFrame {
  std::string parent;
  std::optional<Eigen::Isometry3d> pose;
};

struct Placed {
  std::string frame;
  std::optional<Eigen::Isometry3d> map_from_frame;  ///< if it was placed once
};

class PathPlaces {
 public:
  explicit PathPlaces(unsigned seed)
      : random_(seed), robot_(kDrivingArm, inFrame(seed % 3 == 0 ? "arm" : "map")) {
    send();
    for (int i = 0; i < kObjects; ++i)
      put(i);
  }

  void step() {
    now_ += 1.0 / 64;  // without rounding, also in nanoseconds
    switch (pick(4)) {
      case 0:
        put(pick(kObjects));
        break;
      case 1: {
        auto frame = std::next(seldom_.begin(), pick(static_cast<int>(seldom_.size())));
        frame->second.pose = anyPose();
        robot_.add(frame->second.parent, frame->first, now_, *frame->second.pose);
        break;
      }
      default:
        send();
    }
    robot_.scene().update(ros::Time(now_));
    compare();
  }

  int compared() const { return compared_; }
  int rides() const { return rides_; }

 private:
  static Parameters inFrame(const std::string& fixed_frame) {
    Parameters parameters;
    parameters.fixed_frame = fixed_frame;
    parameters.timeout = 0;
    return parameters;
  }

  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  Eigen::Isometry3d anyPose() {
    const Eigen::Quaterniond turn(number() + 2, number(), number(), number());
    return Eigen::Translation3d(number(), number(), number()) * turn.normalized();
  }

  void send() {
    map_from_base_ = anyPose();
    for (const char* const joint : {"turn", "roll"})
      values_[robot_.joint(joint)] = number();
    sent_ = now_;
    if (map_from_seen_ && pick(4) != 0) return sendWithoutCamera();
    values_[robot_.joint("look")] = number();
    robot_.send(now_, values_, map_from_base_);
    pan_from_seen_ = anyPose();
    robot_.add("pan", "seen", now_, pan_from_seen_);
    map_from_seen_ = *mapFrom("pan") * pan_from_seen_;
  }

  void sendWithoutCamera() {
    robot_.add("map", "base", now_, map_from_base_);
    for (const char* const joint : {"turn", "roll"}) {
      const Joint& moved = robot_.robot().joints[robot_.joint(joint)];
      robot_.add(robot_.robot().links[moved.parent].name, robot_.robot().links[moved.child].name,
                 now_, moved.parent_from_joint * jointMotion(moved, values_[robot_.joint(joint)]));
    }
  }

  /// By what was sent last; nothing if that was never.
  std::optional<Eigen::Isometry3d> mapFrom(const std::string& frame) const {
    if (frame == "map") return Eigen::Isometry3d::Identity();
    if (frame == "seen") return map_from_seen_;
    const auto seldom = seldom_.find(frame);
    if (seldom != seldom_.end()) {
      const auto parent = mapFrom(seldom->second.parent);
      if (!seldom->second.pose || !parent) return std::nullopt;
      return *parent * *seldom->second.pose;
    }
    const auto poses = linkPoses(robot_.robot(), values_);
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (robot_.robot().links[i].name == frame) return map_from_base_ * poses[i];
    return std::nullopt;
  }

  /// A marker that follows its frame or was placed once, or a neighbour's box.
  void put(int number) {
    static const std::vector<std::string> kFrames{"map",   "base",   "arm",    "tool",
                                                  "table", "camera", "person", "seen"};
    Placed& placed = objects_[number];
    placed.frame = kFrames[static_cast<std::size_t>(pick(8))];
    placed.map_from_frame.reset();
    const bool is_robots = placed.frame == "base" || placed.frame == "arm" ||
                           placed.frame == "tool" || placed.frame == "map";
    const int kind = pick(3);
    ObjectContent content = boxIn(placed.frame, kind == 0 ? 0 : sent_);
    if (kind == 1) content.is_neighbour = true;
    if (kind == 2) {
      if (is_robots) {
        placed.map_from_frame = mapFrom(placed.frame);
      } else {
        content.stamp = 0;
      }
    }
    content.bounded.name = "scene/" + std::to_string(number);
    robot_.scene().objects.put({"scene", number}, content, ros::Time(now_));
  }

  void compare() {
    const PathScene path = pathOfNow();
    const auto poses = linkPoses(robot_.robot(), values_);
    for (std::size_t i = 0; i < path.names.size(); ++i) {
      const auto found = path.names[i].rfind("scene/", 0);
      if (found != 0 || !path.bodies[i].is_whole) continue;
      const Placed& placed = objects_.at(path.names[i].back() - '0');
      const bool rides = path.names[i] == path.names[i - 1];  // where the camera is now
      auto expected = placed.map_from_frame ? placed.map_from_frame : mapFrom(placed.frame);
      if (rides) expected = *mapFrom("pan") * pan_from_seen_;
      rides_ += rides;
      ASSERT_TRUE(expected) << path.names[i] << " in " << placed.frame;
      const Eigen::Affine3d at = map_from_base_ * poses[path.bodies[i].link] *
                                 path.bodies[i].body.shapes.at(0).shape.link_from_shape;
      EXPECT_LT((at.matrix() - expected->matrix()).norm(), 1e-9)
          << path.names[i] << " in " << placed.frame << " at " << now_;
      ++compared_;
    }
  }

  PathScene pathOfNow() {
    SceneCopy copy(pathRequest(), robot_.model());
    while (!copy.proceed(robot_.scene(), ros::Time(now_), std::chrono::seconds(1))) {
    }
    const auto past = copy.take();
    const auto goes_on = [] { return false; };
    PathTrees trees([](const auto&, const auto&) { return std::vector<LoadedTree>(); });
    trees.prepare(*past, goes_on);
    return pathScene(*past, {"turn", "roll"}, trees, {1000, goes_on});
  }

  std::mt19937 random_;
  MovingRobot robot_;
  double now_ = MovingRobot::kStamp;
  double sent_ = now_;  ///< the robot, last
  Eigen::Isometry3d map_from_base_;
  Eigen::Isometry3d pan_from_seen_;
  std::optional<Eigen::Isometry3d> map_from_seen_;  ///< what the camera saw stays there
  MovingRobot::Values values_ = {0, 0, 0};
  std::map<std::string, SeldomFrame> seldom_{
      {"table", {"map", {}}}, {"person", {"map", {}}}, {"camera", {"tool", {}}}};
  std::map<int, Placed> objects_;
  int compared_ = 0;
  int rides_ = 0;
};

TEST(PathPlacesRandom, EachBodyIsWhereTheLastTransformsHaveIt) {
  int compared = 0;
  int rides = 0;
  for (unsigned seed = 1; seed <= kSequences && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PathPlaces places(seed);
    for (int step = 0; step < kSteps && !testing::Test::HasFailure(); ++step)
      places.step();
    compared += places.compared();
    rides += places.rides();
  }
  EXPECT_GT(compared, kSequences * kSteps);
  EXPECT_GT(rides, kSequences * kSteps / 4);
}

}  // namespace
}  // namespace link_bounds
