// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each body goes up its tf path to the fixed frame. The motion of an edge is found once per stamp.
#include "world/stopping/stopping_boxes.h"

#include <algorithm>
#include <map>

#include "robot/stopping/moving_link.h"
#include "world/stopping/base_motion.h"
#include "world/stopping/joint_motion.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;

std::int64_t windowOf(const Parameters& parameters) {
  constexpr double kMaxWindow = 10;  // s, all history
  return static_cast<std::int64_t>(std::min(parameters.velocity_window, kMaxWindow) * 1e9);
}

/// How an edge moves at a stamp.
struct EdgeMotion {
  Eigen::Isometry3d parent_from_child = Eigen::Isometry3d::Identity();
  std::optional<MovingJoint> joint;  ///< in the frame of the child; of a base in that of the parent
  std::string problem;
};

MovingJoint placed(MovingJoint joint, const Eigen::Isometry3d& frame) {
  joint.origin = frame * joint.origin;
  joint.axis = frame.linear() * joint.axis;
  return joint;
}

/// Of one copy of the scene.
class StopMaker {
 public:
  StopMaker(PastScene& scene, const StopRules& rules)
      : scene_(scene),
        tf_(scene.excerpt.buffer()),
        rules_(rules),
        window_(windowOf(rules.model().parameters)),
        tracker_(tf_) {
    tracker_.setTarget(scene.target, rules.model().parameters.timeout, scene.now);
    fixed_problem_ = whyFixedFrameMoves();
  }

  StoppingBoxes make();

 private:
  /// What a body is made of.
  struct Made {
    std::optional<Aabb> box;
    std::int64_t stamp = 0;
    std::string problem;
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  };

  /// From a frame up to the fixed frame.
  struct Way {
    std::vector<MovingJoint> joints;  ///< in the frame of the boxes, the first one first
    bool is_carried = false;          ///< by a link of the robot
    std::string problem;
  };

  Made make(const PastBody& body);
  const FramePose& poseOf(Frame frame);
  Way climb(Frame frame, const FramePose& start);
  std::string whyStrangerMoves(Frame frame, std::int64_t stamp);
  std::string whyGroundMoves();
  std::string addBase(std::int64_t stamp, Frame root, std::vector<MovingJoint>& joints);
  const EdgeMotion& motionOf(Frame child, std::int64_t stamp);
  EdgeMotion findMotion(Frame child, std::int64_t stamp);
  EdgeMotion jointMotionOf(Frame child, std::size_t joint, const EdgeSamples& samples,
                           std::int64_t stamp);
  std::optional<Frame> moverOf(const PastBody& body) const;
  std::string whyFixedFrameMoves() const;

  PastScene& scene_;
  TransformBuffer& tf_;
  const StopRules& rules_;
  const std::int64_t window_;
  FrameTracker tracker_;
  std::vector<FrameTracker::Handle> handles_;  ///< after the tracker, so that they end before it
  std::map<std::pair<Frame, std::int64_t>, EdgeMotion> motions_;
  std::map<std::pair<Frame, std::int64_t>, BaseMotion> bases_;
  std::string fixed_problem_;                  ///< if the fixed frame moves with a joint
  std::optional<std::string> ground_problem_;  ///< if it moves with the robot
};

StoppingBoxes StopMaker::make() {
  auto moment = std::make_shared<Moment>();
  moment->model = scene_.model;
  moment->header.frame_id = scene_.frameName();
  StoppingBoxes result;
  std::size_t incomplete = 0;
  for (const PastBody& body : scene_.bodies) {
    Made made;
    if (body.frame) made = make(body);
    if (body.incomplete || !made.problem.empty()) {
      const std::string& reason = made.problem.empty() ? body.reason : made.problem;
      if (incomplete++ == 0) result.problem = body.bounded->name + ": " + reason;
      moment->addIncomplete(body.bounded->name, body.link);
    }
    if (!made.box) continue;
    moment->bodies.push_back({body.link, body.object, made.stamp, *made.box, made.pose});
    const auto stamp = ros::Time().fromNSec(static_cast<std::uint64_t>(made.stamp));
    moment->header.stamp = std::max(moment->header.stamp, stamp);
  }
  if (incomplete > 1)
    result.problem += "; incomplete are " + std::to_string(incomplete - 1) + " more";
  result.moment = std::move(moment);
  return result;
}

const FramePose& StopMaker::poseOf(Frame frame) {
  handles_.push_back(tracker_.follow(frame));
  return handles_.back().pose();
}

/// With which a body moves: an attached object with a frame of its link's rigid body, whatever its
/// own frame is. Nothing if tf has none.
std::optional<Frame> StopMaker::moverOf(const PastBody& body) const {
  const auto rigid_body = body.link ? std::nullopt : rules_.bodyOfObject(body.bounded->name);
  if (!rigid_body) return body.frame;
  for (Frame frame = 0; frame < tf_.size(); ++frame) {
    const auto link = rules_.linkOf(tf_.name(frame));
    if (link && rules_.bodyOfLink(*link) == *rigid_body) return frame;
  }
  return std::nullopt;
}

StopMaker::Made StopMaker::make(const PastBody& body) {
  Made made;
  const FramePose& own = poseOf(*body.frame);
  if (own.problem != TransformProblem::kNone) {
    made.problem = describe(own.problem, tf_.name(*body.frame), scene_.frameName());
    return made;
  }
  made.stamp = own.stamp == 0 ? body.stamp : own.stamp;
  made.pose = own.fixed_from_frame.affine;
  if (body.frame_from_body)
    made.pose =
        *body.frame == scene_.target ? *body.frame_from_body : made.pose * *body.frame_from_body;
  const std::optional<Frame> mover = moverOf(body);
  if (!mover) {
    made.problem = "tf has no frame of the link to which it is attached";
    return made;
  }
  const FramePose& start = poseOf(*mover);
  if (start.problem != TransformProblem::kNone) {
    made.problem = describe(start.problem, tf_.name(*mover), scene_.frameName());
    return made;
  }
  Way way;
  if (start.stamp != 0 || *mover == scene_.target) way = climb(*mover, start);
  made.problem = way.problem;
  if (!made.problem.empty() && way.is_carried) return made;
  // It was placed once, so it does not move with a fixed frame on the robot.
  if (body.frame_from_body && *mover == scene_.target)
    made.problem = whyStrangerMoves(scene_.target, 0);
  made.box = boxOfMoving(*body.bounded, made.pose, way.joints);
  if (!made.box)
    made.problem =
        describe(TransformProblem::kPoseNotFinite, tf_.name(*body.frame), scene_.frameName());
  return made;
}

/// Up to the fixed frame, or to the root and from there on its motion as a base.
StopMaker::Way StopMaker::climb(Frame frame, const FramePose& start) {
  const Frame first = frame;
  Way way;
  Eigen::Isometry3d pose;
  pose.matrix() = start.fixed_from_frame.affine.matrix();
  std::string below;  // why an edge below the first link is not rigid
  for (std::size_t steps = 0;; ++steps) {
    const std::optional<std::size_t> link = rules_.linkOf(tf_.name(frame));
    way.is_carried = way.is_carried || link;
    if (way.is_carried && way.problem.empty()) way.problem = below;
    const bool is_root = link && !rules_.jointAbove(*link);
    if (!way.problem.empty() || frame == scene_.target) break;
    if (is_root) {
      way.problem =
          fixed_problem_.empty() ? addBase(start.stamp, frame, way.joints) : fixed_problem_;
      break;
    }
    if (!tf_.hasParent(frame) || steps > tf_.size()) {
      if (way.is_carried)
        way.problem = "tf does not lead from frame \"" + tf_.name(frame) + "\" to the robot's root";
      break;
    }
    const EdgeMotion& motion = motionOf(frame, start.stamp);
    if (link) way.problem = motion.problem;
    if (!link && below.empty()) below = motion.problem;
    const Eigen::Isometry3d parent = pose * motion.parent_from_child.inverse();
    if (motion.joint) {
      const bool is_base = motion.joint->kind == MovingJoint::Kind::kFree;
      way.joints.push_back(placed(*motion.joint, is_base ? parent : pose));
    }
    pose = parent;
    frame = tf_.parent(frame);
  }
  std::reverse(way.joints.begin(), way.joints.end());
  if (!way.is_carried) way.problem = whyStrangerMoves(first, start.stamp);
  return way;
}

/// Of what no link carries, nothing is known but where it is.
std::string StopMaker::whyStrangerMoves(Frame frame, std::int64_t stamp) {
  if (!ground_problem_) ground_problem_ = whyGroundMoves();
  if (!ground_problem_->empty() || frame == scene_.target || stamp == 0) return *ground_problem_;
  const EdgeSamples samples = pathSamples(tf_, scene_.target, frame, stamp, window_);
  if (!samples.problem.empty()) return samples.problem;
  if (isStill(samples.poses)) return "";
  return "its frame \"" + tf_.name(frame) + "\" moves, and nothing is known of how it brakes";
}

/// A fixed frame on the robot: if it moves against what is above it, all that stands moves in it.
std::string StopMaker::whyGroundMoves() {
  bool is_on_robot = false;
  Frame frame = scene_.target;
  for (std::size_t steps = 0; tf_.hasParent(frame) && steps < tf_.size(); ++steps) {
    is_on_robot = is_on_robot || rules_.linkOf(tf_.name(frame));
    const EdgeSamples samples = edgeSamples(tf_, frame, tf_.newest(frame), window_);
    if (is_on_robot && !(samples.problem.empty() && isStill(samples.poses))) {
      return "the fixed frame \"" + scene_.frameName() + "\" moves with frame \"" +
             tf_.name(frame) +
             "\", or it is not known whether it does; choose a ~fixed_frame that stands";
    }
    frame = tf_.parent(frame);
  }
  return "";
}

std::string StopMaker::addBase(std::int64_t stamp, Frame root, std::vector<MovingJoint>& joints) {
  const auto [entry, is_new] = bases_.try_emplace({root, stamp});
  BaseMotion& motion = entry->second;
  if (is_new) {
    const EdgeSamples samples = pathSamples(tf_, scene_.target, root, stamp, window_);
    motion.problem = samples.problem;
    if (motion.problem.empty())
      motion = baseMotion(samples.poses, window_, rules_.model().parameters);
  }
  if (motion.joint) joints.push_back(*motion.joint);
  return motion.problem;
}

const EdgeMotion& StopMaker::motionOf(Frame child, std::int64_t stamp) {
  const auto [entry, is_new] = motions_.try_emplace({child, stamp});
  if (is_new) entry->second = findMotion(child, stamp);
  return entry->second;
}

/// Of an edge that is no joint of the robot: a problem if it moves.
EdgeMotion StopMaker::findMotion(Frame child, std::int64_t stamp) {
  const EdgeSamples samples = edgeSamples(tf_, child, stamp, window_);
  EdgeMotion result;
  result.problem = samples.problem;
  if (!result.problem.empty()) return result;
  EdgeSample scratch;
  const EdgeSample* const edge = tf_.at(child, stamp, scratch);
  if (!edge || !toIsometry(edge->parent_from_child, result.parent_from_child)) {
    result.problem = "tf has no usable transform of frame \"" + tf_.name(child) + "\" at that time";
    return result;
  }
  const std::optional<std::size_t> link = rules_.linkOf(tf_.name(child));
  const std::optional<std::size_t> joint = link ? rules_.jointAbove(*link) : std::nullopt;
  if (joint) {
    EdgeMotion of_joint = jointMotionOf(child, *joint, samples, stamp);
    of_joint.parent_from_child = result.parent_from_child;
    return of_joint;
  }
  if (!isStill(samples.poses))
    result.problem = "frame \"" + tf_.name(child) + "\" moves, and it is no link of the robot";
  return result;
}

EdgeMotion StopMaker::jointMotionOf(Frame child, std::size_t index, const EdgeSamples& samples,
                                    std::int64_t stamp) {
  EdgeMotion result;
  const JointRule& rule = rules_.rule(index);
  const Joint& joint = *rule.joint;
  const std::string& parent = rules_.frameName(joint.parent);
  if (tf_.name(tf_.parent(child)) != parent) {
    result.problem = "tf has frame \"" + tf_.name(child) + "\" below \"" +
                     tf_.name(tf_.parent(child)) + "\", not below \"" + parent +
                     "\" as the robot description";
    return result;
  }
  if (joint.motion == Motion::kPlanar || joint.motion == Motion::kFloating) {
    const BaseMotion base = baseMotion(samples.poses, window_, rules_.model().parameters);
    return {{}, base.joint, base.problem.empty() ? "" : joint.name + ": " + base.problem};
  }
  if (!hasValue(joint.motion) || joint.axis.isZero(0)) {
    if (!isStill(samples.poses))
      result.problem = "joint \"" + joint.name + "\" moves, but it is fixed";
    return result;
  }
  const JointState state = jointState(joint, samples, stamp, window_);
  result.problem = state.problem;
  if (!result.problem.empty() || samples.is_static) return result;
  result.problem = rule.missing;
  if (!rule.braking) return result;
  const SpeedRange speed = speedAtStamp(state, rule.braking->acceleration);
  MovingJoint moving{
      joint.motion == Motion::kRotation ? MovingJoint::Kind::kTurn : MovingJoint::Kind::kSlide,
      Eigen::Vector3d::Zero(), joint.axis};
  moving.offsets = stopOffsetsWithin(rule, state, speed, rules_.reaction());
  if (moving.offsets.lower < 0 || moving.offsets.upper > 0) result.joint = moving;
  return result;
}

/// The fixed frame on a link that joints move: the root then moves against it, in a way that no
/// parameter describes.
std::string StopMaker::whyFixedFrameMoves() const {
  Frame frame = scene_.target;
  for (std::size_t steps = 0; steps <= tf_.size(); ++steps) {
    const auto link = rules_.linkOf(tf_.name(frame));
    const auto above = link ? rules_.jointAbove(*link) : std::nullopt;
    if (above && rules_.rule(*above).joint->motion != Motion::kNone) {
      return "the fixed frame \"" + scene_.frameName() + "\" moves with joint \"" +
             rules_.rule(*above).joint->name + "\"; choose a ~fixed_frame that no joint moves";
    }
    if (!tf_.hasParent(frame)) break;
    frame = tf_.parent(frame);
  }
  return "";
}

}  // namespace

BoxRequest stoppingRequest(const Parameters& parameters) {
  BoxRequest request;
  request.span = windowOf(parameters);
  return request;
}

StoppingBoxes stoppingBoxes(PastScene& scene, const StopRules& rules) {
  return StopMaker(scene, rules).make();
}

}  // namespace link_bounds
