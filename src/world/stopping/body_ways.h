// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds in a copy of the scene which joints move a body, and how they move.
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
  MovingJoint place;                 ///< in the frame of BodyWay::pose; joints without offsets
  std::optional<std::size_t> joint;  ///< its index in the robot; nothing: a base
  JointState state;                  ///< only for joints
  bool is_speed_known = false;
  double between = 0;  ///< time from the nearest transform to the stamp of the body [s]
};

/// How a body moves.
struct BodyWay {
  std::int64_t stamp = 0;  ///< of its pose [ns]; 0: all is static
  /// The pose was true at this time at the latest [ns]: the stamp, minus the time by which a
  /// publisher of tf stamps ahead of our clock.
  std::int64_t known = 0;
  bool has_pose = false;
  bool is_placed =
      false;  ///< the body gets a box, because its motion or its resting place is known
  /// In the frame of the boxes. For contacts in the frame of the root, if the root may move in the
  /// frame of the boxes.
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  std::vector<WayJoint> joints;  ///< the one nearest to the root first
  std::string problem;           ///< why the motion is not fully known, or ""
};

/// kStandstill: where bodies can be until the robot stands, if it brakes. The way includes the
/// base, and a joint without a known speed is a problem. kContact: how soon bodies can touch if
/// nothing brakes. The way begins at the root, and every edge that is not a joint must be unable to
/// move.
enum class WayPurpose { kStandstill, kContact };

class BodyWays {
 public:
  /// `states` may be null. All arguments must outlive this.
  BodyWays(PastScene& scene, const StopRules& rules, WayPurpose purpose, const JointStates* states);

  BodyWay find(const PastBody& body);

 private:
  using Frame = TransformBuffer::Frame;

  /// How an edge moves at a stamp.
  struct EdgeMotion {
    Eigen::Isometry3d parent_from_child = Eigen::Isometry3d::Identity();
    std::optional<WayJoint> joint;  ///< in the frame of the child; a base in that of the parent
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
  std::string fixed_problem_;                  ///< why the fixed frame moves with a joint, or ""
  std::optional<std::string> ground_problem_;  ///< see groundProblem()
};

/// The request for the copy of the scene that BodyWays needs.
BoxRequest wayRequest(const Parameters& parameters);

/// Boxes of all bodies of a scene, in the order of ~boxes. Each has the stamp of its pose.
struct WayBoxes {
  std::shared_ptr<const Moment> moment;
  std::vector<BodyWay> ways;  ///< one per body of the moment
  std::string problem;     ///< why the first incomplete body is incomplete, and how many more are
  bool have_poses = true;  ///< all bodies that have a frame have a pose
};

/// `box_of` makes the box of a body that is placed. It returns nothing if numbers are too large.
WayBoxes wayBoxes(
    PastScene& scene, BodyWays& ways,
    const std::function<std::optional<Aabb>(const PastBody&, const BodyWay&)>& box_of);

}  // namespace link_bounds
