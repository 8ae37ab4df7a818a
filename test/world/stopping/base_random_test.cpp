// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random bases that drive in one frame of tf, while the other frames between the root and the fixed
// frame rest, drift, jump and shake, or by a floating joint, whose transforms are newer than those
// of the arm: every stop that the parameters allow is in the boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "testing/moving_robot.h"

namespace link_bounds {
namespace {

constexpr char kFloatingJoint[] = R"(<link name="map"/>
  <joint name="drive" type="floating"><parent link="map"/><child link="base"/></joint>)";
constexpr char kBall[] = R"(<origin xyz="0.3 0 0"/><geometry><sphere radius="0.08"/></geometry>)";
constexpr char kRod[] =
    R"(<origin xyz="0.15 0 0"/><geometry><box size="0.3 0.02 0.02"/></geometry>)";

/// Below `root`.
std::string cart(const std::string& root, const std::string& arm) {
  return "<robot name=\"cart\">" + root + R"(
  <link name="base"><visual><origin xyz="0.1 0 0.2" rpy="0 0 0.3"/>
    <geometry><box size="0.4 0.3 0.2"/></geometry></visual></link>
  <link name="arm"><visual>)" +
         arm + R"(</visual></link>
  <joint name="pan" type="continuous"><parent link="base"/><child link="arm"/>
    <origin xyz=")" +
         (root.empty() ? R"(0.1 0 0.2" rpy="0.1 0.2 0.3)" : "0 0 0") +
         R"("/><axis xyz="0 0 1"/></joint>
</robot>)";
}

Eigen::Isometry3d turned(const Eigen::Vector3d& axis, double angle) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis));
}

/// A body that keeps its speeds, as seen from itself.
struct Twist {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double speed = 0;       ///< [m/s]
  double turn_speed = 0;  ///< [rad/s]
};

/// Where it gets to that goes on by so much, in steps that are short.
Eigen::Isometry3d goneOn(Eigen::Isometry3d pose, const Twist& twist, double way, double turn) {
  const int steps = 1 + static_cast<int>(std::abs(turn) / 0.002);
  for (int i = 0; i < steps; ++i) {
    const Eigen::Isometry3d half = turned(twist.axis, turn / steps / 2);
    pose = pose * half * Eigen::Translation3d(twist.direction * (way / steps)) * half;
  }
  return pose;
}

/// How far one gets until `time` that keeps its speed for the reaction time and then brakes.
double wayUntil(double time, double speed, double reaction, double deceleration) {
  const double braked = std::max(0.0, std::min(time - reaction, std::abs(speed) / deceleration));
  return speed * std::min(time, reaction) +
         std::copysign(std::abs(speed) * braked - deceleration * braked * braked / 2, speed);
}

enum class Drive { kByFrames, kByJoint };

class RandomDrive {
 public:
  RandomDrive(std::uint64_t seed, Drive drive)
      : random_(seed),
        is_base_later_(drive == Drive::kByJoint),
        robot_(drive == Drive::kByJoint ? cart(kFloatingJoint, kRod) : cart("", kBall),
               randomParameters(drive)) {
    twist_ = {direction(), pick(4) == 0 ? direction() : Eigen::Vector3d::UnitZ(),
              pick(4) == 0 ? 0 : random_.uniform(0, 2), pick(3) == 0 ? 0 : random_.uniform(-2, 2)};
    pan_speed_ = pick(2) * random_.uniform(-2, 2);
    pan_ = random_.uniform(-3, 3);
    if (drive == Drive::kByJoint)
      driveByJoint();
    else
      driveByFrames();
    robot_.scene().update(ros::Time(kStamp));
    found_ = robot_.stopping();
  }

  bool isComplete() const { return found_.moment->incomplete.empty(); }

  /// Some stop that the parameters allow, after which the frames stay where they are. `later`: by
  /// so many times the way, which is too far where it is above 1.
  bool coversStop(double later) {
    const Parameters& parameters = robot_.model()->parameters;
    const double reaction = parameters.reaction_time * (pick(2) ? 1 : random_.uniform(0, 1));
    const auto deceleration = [&](double slowest) {
      return slowest * (pick(2) ? 1 : random_.magnitude(0, 1));
    };
    const double linear = deceleration(parameters.base_deceleration.at("linear"));
    const double angular = deceleration(parameters.base_deceleration.at("angular"));
    const double pan = deceleration(parameters.deceleration.at("pan"));
    const double end =
        reaction + std::max({twist_.speed / linear, std::abs(twist_.turn_speed) / angular,
                             std::abs(pan_speed_) / pan});
    Eigen::Isometry3d pose = base_.back();
    double way = 0, turn = 0;
    for (int i = 1; i <= kSteps; ++i) {
      const double time = end * i / kSteps;
      const double next_way = wayUntil(time, twist_.speed, reaction, linear);
      const double next_turn = wayUntil(time, twist_.turn_speed, reaction, angular);
      pose = goneOn(pose, twist_, later * (next_way - way), later * (next_turn - turn));
      way = next_way;
      turn = next_turn;
      const double angle = pan_ + wayUntil(time, pan_speed_, reaction, pan);
      if (!covers(ways_.back().back().inverse() * pose, angle)) return false;
    }
    return true;
  }

 private:
  static constexpr double kStamp = MovingRobot::kStamp;
  static constexpr double kRate = MovingRobot::kRate;
  static constexpr int kSamples = 30;
  static constexpr int kSteps = 60;

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  Eigen::Vector3d direction() { return random_.rotation() * Eigen::Vector3d::UnitX(); }

  Eigen::Isometry3d place() {
    Eigen::Isometry3d result(random_.rotation());
    result.translation() = random_.vector(2);
    return result;
  }

  /// Of joints such that it turns for longer than it drives.
  Parameters randomParameters(Drive drive) {
    Parameters parameters;
    parameters.fixed_frame = "map";
    parameters.velocity_window = random_.uniform(0.05, 0.2);
    parameters.reaction_time = pick(3) == 0 ? 0 : random_.uniform(0, 0.3);
    parameters.deceleration["pan"] = random_.magnitude(-0.3, 1);
    parameters.base_deceleration = {{"linear", random_.magnitude(-0.3, 1)},
                                    {"angular", random_.magnitude(0, 1)}};
    if (drive == Drive::kByJoint) {
      parameters.reaction_time = 0;
      parameters.base_deceleration = {{"linear", random_.magnitude(0.5, 2)},
                                      {"angular", random_.magnitude(-0.5, 0.3)}};
    }
    return parameters;
  }

  void driveByFrames() {
    const int between = pick(4);
    names_.emplace_back("base");
    for (int i = 0; i < between; ++i)
      names_.push_back("between_" + std::to_string(i));
    names_.emplace_back("map");
    ground_ = 1 + static_cast<std::size_t>(pick(between + 1));
    top_ = static_cast<std::size_t>(pick(between + 2));
    const Eigen::Isometry3d base = place();
    for (int i = 0; i <= kSamples; ++i)
      base_.push_back(
          goneOn(base, twist_, twist_.speed * i / kRate, twist_.turn_speed * i / kRate));
    ways_.push_back(base_);
    for (std::size_t i = 1; i < names_.size(); ++i)
      ways_.push_back(
          i == ground_ ? std::vector<Eigen::Isometry3d>(kSamples + 1, Eigen::Isometry3d::Identity())
                       : frameWay());
    for (int i = 0; i <= kSamples; ++i)
      send(static_cast<std::size_t>(i));
  }

  /// A stop begins where tf has the base, between two transforms.
  void driveByJoint() {
    const double period = random_.uniform(0.5, 0.95) * robot_.model()->parameters.velocity_window;
    const double ahead = random_.uniform(0, 1) * period;
    const Eigen::Isometry3d base = place();
    const auto at = [&](double time) {
      return goneOn(base, twist_, twist_.speed * time, twist_.turn_speed * time);
    };
    for (int i = kSamples; i >= 0; --i) {
      const double time = ahead - i * period;
      robot_.add("map", "base", kStamp + time, at(time));
      sendArm(kStamp - i / kRate);
    }
    const Eigen::Isometry3d before = at(ahead - period), after = at(ahead);
    const double part = 1 - ahead / period;
    Eigen::Isometry3d between(
        Eigen::Quaterniond(before.linear()).slerp(part, Eigen::Quaterniond(after.linear())));
    between.translation() = (1 - part) * before.translation() + part * after.translation();
    base_ = {between};
    ways_ = {{Eigen::Isometry3d::Identity()}};
  }

  /// Of a frame that is neither the base nor the ground, as seen from the ground.
  std::vector<Eigen::Isometry3d> frameWay() {
    const int manner = pick(5);
    Eigen::Isometry3d pose = place();
    const Twist twist{direction(), direction(), random_.uniform(0, 2), random_.uniform(-1, 1)};
    const int jump = pick(kSamples);
    std::vector<Eigen::Isometry3d> result;
    for (int i = 0; i <= kSamples; ++i) {
      if (manner == 1) pose = goneOn(pose, twist, twist.speed / kRate, twist.turn_speed / kRate);
      if (manner == 2 && i == jump)
        pose = pose * turned(direction(), random_.uniform(0, 0.5)) *
               Eigen::Translation3d(random_.vector(0.5));
      const double shakes = manner == 3 ? 1e-3 : 0;
      result.push_back(pose * turned(direction(), random_.uniform(0, shakes)) *
                       Eigen::Translation3d(random_.vector(shakes)));
    }
    if (manner != 4) return result;
    for (std::size_t i = 0; i < result.size(); ++i)  // it rides on the base
      result[i] = base_[i] * pose;
    return result;
  }

  void send(std::size_t sample) {
    const double stamp = kStamp - (kSamples - static_cast<double>(sample)) / kRate;
    for (std::size_t i = 0; i + 1 < names_.size(); ++i) {
      const bool is_up = i < top_;  // the frame with the greater number is the parent
      const std::size_t child = is_up ? i : i + 1, parent = is_up ? i + 1 : i;
      robot_.add(names_[parent], names_[child], stamp,
                 ways_[parent][sample].inverse() * ways_[child][sample]);
    }
    sendArm(stamp);
  }

  void sendArm(double stamp) {
    const Joint& pan = robot_.robot().joints[robot_.joint("pan")];
    robot_.add("base", "arm", stamp,
               pan.parent_from_joint * jointMotion(pan, pan_ - pan_speed_ * (kStamp - stamp)));
  }

  bool covers(const Eigen::Isometry3d& map_from_base, double pan) const {
    constexpr double kRounding = 1e-9;
    const auto boxes = robot_.boxesAt(robot_.values({{"pan", pan}}), map_from_base);
    return std::all_of(found_.moment->bodies.begin(), found_.moment->bodies.end(),
                       [&](const Moment::Body& body) {
                         const std::string name(found_.moment->name(body));
                         if (is_base_later_ && name == "base") return true;
                         const Aabb& box = boxes.at(name);
                         return padded(body.box, kRounding).contains(box);
                       });
  }

  brute_force::Random random_;
  const bool is_base_later_;  ///< its box has a later stamp than that of the arm
  MovingRobot robot_;
  Twist twist_;  ///< of the base in the ground
  double pan_speed_ = 0;
  double pan_ = 0;
  std::vector<std::string> names_;  ///< from the base to the map
  std::size_t ground_ = 0;          ///< the frame in which the base drives
  std::size_t top_ = 0;             ///< the root of tf
  std::vector<Eigen::Isometry3d> base_;
  std::vector<std::vector<Eigen::Isometry3d>> ways_;  ///< of all names, in the ground
  WayBoxes found_;
};

void expectStopsInside(Drive manner) {
  constexpr std::uint64_t kDrives = 4000;
  std::uint64_t complete = 0, left = 0;
  for (std::uint64_t seed = 1; seed <= kDrives; ++seed) {
    RandomDrive drive(seed, manner);
    if (!drive.isComplete()) continue;
    ++complete;
    for (int i = 0; i < 5; ++i)
      EXPECT_TRUE(drive.coversStop(1)) << seed;
    left += !drive.coversStop(5);
  }
  EXPECT_GT(complete, kDrives * 3 / 4) << "of the others nothing was shown";
  EXPECT_GT(left, complete / 4) << "boxes that hold everything show nothing";
}

TEST(BaseRandom, EveryAllowedStopIsInTheBoxes) {
  expectStopsInside(Drive::kByFrames);
}

TEST(BaseRandom, EveryAllowedStopOfAFloatingJointIsInTheBoxes) {
  expectStopsInside(Drive::kByJoint);
}

}  // namespace
}  // namespace link_bounds
