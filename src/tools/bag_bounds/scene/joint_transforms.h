// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Recorded joint values as the transforms that robot_state_publisher would have sent.
#pragma once

#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/robot/urdf/robot.h"
#include "robot/urdf/joint_ranges.h"
#include "world/tf/tf_message.h"

namespace link_bounds {

/// Gives no transform of the root link. Floating and planar joints have no value in a JointState,
/// so their links have no transforms either. Not copyable: the transforms are views of its names.
class JointTransforms {
 public:
  /// Throws JointError for mimic joints that follow each other in a circle or follow no joint.
  JointTransforms(Robot robot, const std::string& tf_prefix);
  JointTransforms(const JointTransforms&) = delete;
  JointTransforms& operator=(const JointTransforms&) = delete;

  /// The transforms of all fixed joints.
  std::vector<TransformView> fixed() const;

  /// Transforms of the joints in the message, one per name, and of joints that mimic them and are
  /// not in the message. Ignores other names: those of other robots, or of joints that are not in
  /// the URDF. If a joint turned by more than tf2 can interpolate, transforms on its way come
  /// before the last one.
  std::vector<TransformView> of(const sensor_msgs::JointState& message, ros::Time stamp);

  /// Forgets where the joints were. To be called when the clock jumps back, as tf forgets then.
  void forget() { last_.clear(); }

  /// A message about turns whose direction is not known; "" if there are none.
  std::string loss() const;

  /// Joints that have a value of their own, but were in no message so far.
  std::vector<std::string> missing() const;

 private:
  using Values = std::map<std::string, double>;  // by the name of the joint

  /// The position of a joint in a message: `value` is `factor` times `of_leader`, plus an offset.
  struct Position {
    const Joint* leader;  ///< the joint that the message has; maybe the joint itself
    double factor;
    double of_leader;
    double value;
    ros::Time stamp;
  };

  /// By how much a joint turned between two messages [rad].
  struct Way {
    double turn;
    bool is_sure;
  };

  void addTurn(const Joint& joint, const Position& next, std::vector<TransformView>& result);
  static Way wayBetween(const Joint& joint, const Position& last, const Position& next);
  std::optional<Position> positionOf(const Joint& joint, const Values& told, ros::Time stamp) const;
  TransformView transformOf(const Joint& joint, double value, ros::Time stamp) const;

  Robot robot_;
  std::vector<std::string> frames_;  ///< of the links
  std::map<std::string, const Joint*> joints_;
  std::map<std::string, bool> is_met_;     ///< by leader: a message had it
  std::map<const Joint*, Position> last_;  ///< the newest finite one
  std::uint64_t ambiguous_ = 0;            ///< number of turns of unknown direction
  std::string first_ambiguous_;            ///< the joint of the first of these turns
};

}  // namespace link_bounds
