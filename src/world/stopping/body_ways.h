// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds which joints move a body, and how they move, from one copy of the scene.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/stopping/moving_link.h"
#include "world/history/past_scene.h"
#include "world/moment/moment.h"
#include "world/stopping/base_motion.h"
#include "world/stopping/joint_speed.h"
#include "world/stopping/joint_states.h"
#include "world/stopping/stop_rules.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {

/// A joint, or a base, on the way from the root to a body.
struct WayJoint {
  MovingJoint place;                 ///< in the frame of BodyWay::pose; offsets not set
  std::optional<std::size_t> joint;  ///< its index in the robot; nothing: a base
  JointState state;                  ///< not set for a base
  bool is_speed_known = false;
  double between = 0;  ///< time from the nearest transform to the stamp of the body [s]
};

/// How a body moves.
struct BodyWay {
  std::int64_t stamp = 0;  ///< of its pose [ns]; 0: all its transforms are static
  /// From this time on the body may have left the pose [ns]: the stamp, or earlier if the clock of
  /// a publisher is ahead.
  std::int64_t known = 0;
  bool has_pose = false;
  bool is_placed = false;  ///< it has a box, which may be too small if there is a problem
  /// In the frame of the boxes; for contacts, in the root's frame if the root may move.
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  std::vector<WayJoint> joints;  ///< the one nearest to the root first
  std::string problem;           ///< why the motion is not fully known; "" if it is
};

/// kStandstill is for boxes around the motion until the robot stands. The way includes the base,
/// and the speed of each joint must be known. kContact is for the earliest contacts if nothing
/// brakes. The way begins at the root, and edges that are no joints must be rigid.
enum class WayPurpose { kStandstill, kContact };

class BodyWays {
 public:
  /// `states` may be null. All must outlive this.
  BodyWays(PastScene& scene, const StopRules& rules, WayPurpose purpose, const JointStates* states);

  BodyWay find(const PastBody& body);

 private:
  using Frame = TransformBuffer::Frame;

  /// How an edge moves at a stamp.
  struct EdgeMotion {
    Eigen::Isometry3d parent_from_child = Eigen::Isometry3d::Identity();
    std::optional<WayJoint> joint;  ///< in the frame of the child; a base: of the parent
    std::string problem;
  };

  bool isContact() const { return purpose_ == WayPurpose::kContact; }
  std::optional<Frame> moverOf(const PastBody& body) const;
  std::string whyNotHeld(const PastBody& body, Frame mover, const FramePose& start,
                         std::int64_t pose_stamp) const;
  bool climb(Frame frame, const FramePose& start, BodyWay& way);
  const std::string& groundProblem();
  static void moveInto(const Eigen::Isometry3d& root, BodyWay& way);
  std::int64_t knownSince(Frame frame, std::int64_t stamp) const;
  std::optional<Frame> edgeInDoubt(Frame frame) const;
  std::string whyStrangerMoves(Frame frame, std::int64_t stamp);
  std::string whyGroundMoves() const;
  std::string whyRootMoves() const;
  std::string whyFixedFrameMoves() const;
  bool isRigid(Frame child) const;
  bool isStillInTf(Frame child) const;
  std::string addBase(std::int64_t stamp, Frame root, std::vector<WayJoint>& joints);
  BaseMotion baseIn(Frame frame, std::int64_t stamp, Frame root) const;
  BaseMotion findBase(std::int64_t stamp, Frame root) const;
  const EdgeMotion& motionOf(Frame child, std::int64_t stamp);
  EdgeMotion findMotion(Frame child, std::int64_t stamp);
  void addJoint(Frame child, std::size_t joint, std::int64_t stamp, EdgeMotion& edge);
  void addFreeJoint(Frame child, const Joint& joint, std::int64_t stamp, EdgeMotion& edge);
  JointState stateOf(Frame child, const JointRule& rule, std::int64_t stamp,
                     const Eigen::Isometry3d& pose) const;

  PastScene& scene_;
  TransformBuffer& tf_;
  const StopRules& rules_;
  const WayPurpose purpose_;
  const JointStates* const states_;
  const std::int64_t window_;
  FrameTracker tracker_;
  std::map<std::pair<Frame, std::int64_t>, EdgeMotion> motions_;
  std::map<std::pair<Frame, std::int64_t>, BaseMotion> bases_;
  std::string fixed_problem_;                  ///< see whyFixedFrameMoves()
  std::optional<std::string> ground_problem_;  ///< see groundProblem()
};

/// The request for a copy of the scene that BodyWays can use.
BoxRequest wayRequest(const Parameters& parameters);

/// Boxes of all bodies of a scene, in the order and with the stamps of ~boxes.
struct WayBoxes {
  std::shared_ptr<const Moment> moment;
  std::vector<BodyWay> ways;  ///< one per body of the moment
  std::string problem;        ///< why the first incomplete body is incomplete; number of others
  bool have_poses = true;     ///< each body that has a frame has a pose
};

/// `box_of` makes the box of a body with is_placed; nothing if its numbers are too large.
WayBoxes wayBoxes(
    PastScene& scene, BodyWays& ways,
    const std::function<std::optional<Aabb>(const PastBody&, const BodyWay&)>& box_of);

}  // namespace link_bounds
