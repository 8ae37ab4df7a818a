// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot whose joints move, as tf tells it, and what can be reached from there.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/kinematics.h"
#include "testing/live_boxes_testing.h"
#include "world/history/scene_copy.h"
#include "world/stopping/contact_times.h"
#include "world/stopping/stopping_boxes.h"

namespace link_bounds {

/// Sends tf of a robot and computes what it can reach.
class MovingRobot {
 public:
  using Values = std::vector<double>;  ///< by joint of the robot

  /// Without meshes.
  MovingRobot(const std::string& urdf, const Parameters& parameters)
      : MovingRobot(urdf, parameters, [](const MeshFile&) { return TriangleMesh(); }, {}) {}

  template <class Import>
  MovingRobot(const std::string& urdf, const Parameters& parameters, Import import,
              const MeshSource& source)
      : scene_(tf_) {
    RobotLoader loader(import);
    model_ = std::make_shared<const Model>(makeModel(urdf, parameters, loader, source));
    scene_.adopt(model_, ros::Time(kStamp));
  }

  static constexpr double kRate = 100;    ///< Hz, of tf
  static constexpr double kStamp = 10.0;  ///< s, of the newest transforms

  const Robot& robot() const { return *model_->robot; }

  std::size_t joint(const std::string& name) const {
    for (std::size_t i = 0; i < robot().joints.size(); ++i) {
      if (robot().joints[i].name == name) return i;
    }
    throw std::out_of_range(name);
  }

  /// Mimic joints follow.
  Values values(std::map<std::string, double> given) const { return jointValues(robot(), given); }

  void send(double stamp, const Values& values,
            const Eigen::Isometry3d& map_from_base = Eigen::Isometry3d::Identity()) {
    add("map", robot().links[robot().root].name, stamp, map_from_base);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Joint& joint = robot().joints[i];
      add(robot().links[joint.parent].name, robot().links[joint.child].name, stamp,
          joint.parent_from_joint * jointMotion(joint, values[i]));
    }
    scene_.update(ros::Time(kStamp));
  }

  void add(const std::string& parent, const std::string& child, double stamp,
           const Eigen::Isometry3d& pose, bool is_static = false) {
    const auto transform =
        edge(parent, child, stamp, Eigen::Quaterniond(pose.linear()), pose.translation());
    tf_.add({transform}, is_static, ros::Time(kStamp));
  }

  /// All joints at constant speeds until kStamp; at the end they have `values`.
  void move(const Values& values, const Values& speeds) {
    for (int i = 20; i >= 0; --i) {
      Values then = values;
      for (std::size_t j = 0; j < then.size(); ++j)
        then[j] -= speeds[j] * i / kRate;
      send(kStamp - i / kRate, then);
    }
  }

  std::unique_ptr<PastScene> copy(double now = kStamp) {
    SceneCopy copy(wayRequest(model_->parameters), model_);
    while (!copy.proceed(scene_, ros::Time(now), std::chrono::seconds(1))) {
    }
    return copy.take();
  }

  WayBoxes stopping(const JointStates* states = nullptr) {
    return stoppingBoxes(*copy(kStamp), StopRules(model_), states);
  }

  EarliestContactArray earliest(double now = kStamp, const JointStates* states = nullptr) {
    static const auto goes_on = [] { return false; };
    const auto time = std::chrono::steady_clock::now();
    ContactTimes contacts({[](const auto&, const auto&) {}, [](const auto&) {}});
    return contacts.compute(*copy(now), StopRules(model_), states, time, goes_on)->array;
  }

  std::vector<std::string> incomplete() { return stopping().moment->incomplete; }

  /// The boxes of all links there.
  std::map<std::string, Aabb> boxesAt(
      const Values& values,
      const Eigen::Isometry3d& map_from_base = Eigen::Isometry3d::Identity()) const {
    std::map<std::string, Aabb> result;
    const auto poses = linkPoses(robot(), values);
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
      const Eigen::Affine3d pose(map_from_base * poses[model_->robot_links[i]]);
      result.emplace(model_->links[i].name, *linkBox(model_->links[i], pose));
    }
    return result;
  }

  Scene& scene() { return scene_; }
  const std::shared_ptr<const Model>& model() const { return model_; }
  TransformBuffer& tf() { return tf_; }

 private:
  TransformBuffer tf_;
  Scene scene_;
  std::shared_ptr<const Model> model_;
};

}  // namespace link_bounds
