// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Fixes the joints that rest, then places bodies on links, then makes pairs.
#include "world/path/path_scene.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/stopping/joint_fit.h"
#include "robot/urdf/simple_joints.h"
#include "world/stopping/joint_speed.h"
#include "world/tf/frame_paths.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;

/// For each joint of the URDF: whether the trajectory moves it, directly or because it mimics one
/// of the joints `names`.
std::vector<bool> movedJoints(const Robot& robot, const std::set<std::string>& names) {
  const Robot simple = withSimpleJoints(robot);
  const std::vector<Lead> leads = leadsOf(simple);
  std::map<std::string, std::vector<bool>> parts;  // by joint of the URDF, one per simple joint
  for (std::size_t i = 0; i < simple.joints.size(); ++i) {
    const Joint& joint = simple.joints[i];
    const bool moves = names.count(simple.joints[leads[i].leader].name) > 0;
    parts[joint.part_of.empty() ? joint.name : joint.part_of].push_back(moves);
  }
  std::vector<bool> result;
  for (const Joint& joint : robot.joints) {
    const std::vector<bool>& moves = parts[joint.name];
    const auto count = std::count(moves.begin(), moves.end(), true);
    if (count > 0 && count < static_cast<std::ptrdiff_t>(moves.size()))
      throw std::runtime_error("the trajectory has some values of joint \"" + joint.name +
                               "\", but not all " + std::to_string(moves.size()) +
                               "; add the others");
    result.push_back(count > 0);
  }
  return result;
}

class SceneMaker {
 public:
  SceneMaker(PastScene& scene, const PathTrees& trees)
      : scene_(scene),
        model_(*scene.model),
        original_(*model_.robot),
        tf_(scene.excerpt.buffer()),
        tracker_(tf_),
        trees_(trees),
        rigid_in_urdf_(rigidBodies(original_)) {
    tracker_.setTarget(scene.target, model_.parameters.timeout, scene.now);
    for (std::size_t i = 0; i < scene.robot_frames.size(); ++i) {
      if (scene.robot_frames[i]) links_.emplace(*scene.robot_frames[i], i);
    }
  }

  PathScene make(const std::set<std::string>& joints, const PathLimits& limits) {
    Robot robot = original_;
    const std::vector<bool> moves = movedJoints(original_, joints);
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      if (moves[i])
        moveFromTf(robot.joints[i]);
      else
        rest(robot.joints[i]);
    }
    rigid_ = rigidBodies(robot);
    result_.robot = withSimpleJoints(robot);
    for (const PastBody& body : scene_.bodies)
      add(body);
    addPairs(limits);
    return std::move(result_);
  }

 private:
  /// Why the frame has no pose in the target frame; "" if it has one.
  std::string problemOf(Frame frame) {
    return describe(tracker_.keep(frame).problem, tf_.name(frame), tf_.name(scene_.target));
  }

  /// Finds the latest pose of the joint's child in its parent. Returns why there is none, or "".
  /// The pose of a fixed joint counts even if tf does not connect it with the fixed frame.
  std::string findPose(const Joint& joint, Eigen::Isometry3d& parent_from_child) {
    const auto& parent = scene_.robot_frames[joint.parent];
    const auto& child = scene_.robot_frames[joint.child];
    const std::string link = "link \"" + original_.links[joint.child].name + "\"";
    if (!parent || !child) return "tf has no frame of " + link;
    const std::string problem = joint.motion == Motion::kNone ? "" : problemOf(*child);
    if (!problem.empty()) return problem;
    const std::optional<Tf2Pose> pose = tf_.pose(*parent, *child, 0);
    if (pose && toIsometry(*pose, parent_from_child)) return "";
    return "tf has no usable pose of " + link + " in that of its parent";
  }

  /// A joint that the trajectory moves must fit its transform if tf has one. The axis of a joint
  /// with one value is taken from tf, because a calibrated robot differs a little from its
  /// description.
  void moveFromTf(Joint& joint) {
    Eigen::Isometry3d parent_from_child;
    const bool has_axis = hasValue(joint.motion) || joint.motion == Motion::kPlanar;
    if (!has_axis || joint.axis.isZero(0)) return;
    if (!findPose(joint, parent_from_child).empty()) return;
    const JointFit fit = fitOf(joint, parent_from_child);
    const std::string misfit = whyMisfit(joint, fit);
    if (!misfit.empty()) throw std::runtime_error(misfit);
    if (hasValue(joint.motion))
      joint.parent_from_joint = parent_from_child * jointMotion(joint, fit.value).inverse();
  }

  /// Fixes a joint at its latest pose in tf. A fixed joint that tf does not have keeps the pose of
  /// the robot description.
  void rest(Joint& joint) {
    Eigen::Isometry3d parent_from_child;
    const std::string problem = findPose(joint, parent_from_child);
    if (problem.empty()) joint.parent_from_joint = parent_from_child;
    if (joint.motion == Motion::kNone) return;
    if (!problem.empty())
      throw std::runtime_error("joint \"" + joint.name +
                               "\" is not in the trajectory, and where it is now is not known: " +
                               problem + "; add the joint, or publish its transform");
    joint.motion = Motion::kNone;
    joint.mimic.reset();
  }

  struct Carrier {
    std::size_t link;
    bool is_elsewhere = false;  ///< the object's frame is not below this link's rigid body
    bool is_known = true;       ///< false: the object may move with any link
    bool is_beside = false;     ///< it has a place of its own, see groundOf(); `link` is the root
    /// The resting link above the object's frame. It is unknown whether the object is mounted
    /// there, or whether a camera there saw it, so that it stays behind when the base drives.
    std::optional<std::size_t> may_ride = std::nullopt;
  };

  void add(const PastBody& body) {
    const std::string& name = body.bounded->name;
    std::string problem = body.incomplete || !body.bounded->isWhole() ? body.reason : "";
    if (body.link) {
      push({model_.robot_links[*body.link], trees_.bodyOf(*body.bounded), body.bounded->isWhole()},
           {&name, body.link}, problem);
      return;
    }
    const Carrier carrier = carrierOf(body);
    addPlaced(body, carrier, problem);
    if (carrier.may_ride) addPlaced(body, {*carrier.may_ride}, problem);
  }

  /// Adds the body at its place on the carrier.
  void addPlaced(const PastBody& body, const Carrier& carrier, std::string problem) {
    PathBody placed{carrier.link, {}, false};
    if (body.frame) {
      placed = placedObject(body, carrier, problem);
      placed.is_whole = problem.empty();
    } else if (problem.empty()) {
      problem = "it has no place";
    }
    if (problem.empty() && !carrier.is_known && mayStayBehind(body, carrier.link)) {
      problem =
          "it was placed once in the fixed frame, which the trajectory moves; "
          "send it with stamp 0, or choose another fixed frame";
      placed.is_whole = false;
    }
    if (!carrier.is_known) strays_.push_back(result_.bodies.size());
    push(std::move(placed), {&body.bounded->name, std::nullopt}, problem);
  }

  void push(PathBody body, PairMember member, const std::string& problem) {
    result_.bodies.push_back(std::move(body));
    result_.names.push_back(*member.name);
    members_.push_back(member);
    problems_.push_back(problem);
  }

  /// The object on the link that carries it. Fills `problem` if its place is not known.
  PathBody placedObject(const PastBody& body, const Carrier& carrier, std::string& problem) {
    const std::size_t link = carrier.link;
    PathBody result{link, {}, false};
    const auto link_frame = scene_.robot_frames[link];
    std::string place_problem = link_frame ? "" : "tf has no frame of the link that carries it";
    for (const auto& frame : {body.frame, link_frame}) {
      if (frame && place_problem.empty()) place_problem = problemOf(*frame);
    }
    if (place_problem.empty() && carrier.is_elsewhere)
      place_problem = whyNotHeld(body, *link_frame);
    Frame base = 0;
    if (place_problem.empty())
      base = carrier.is_beside ? groundOf(*link_frame, *body.frame) : *link_frame;
    for (const auto& frame : {link_frame, body.frame}) {
      if (place_problem.empty()) place_problem = problemOn(base, *frame);
    }
    if (!place_problem.empty()) {
      problem = place_problem;
      return result;
    }
    const Eigen::Affine3d base_from_link = poseOn(base, *link_frame).fixed_from_frame.affine;
    Eigen::Affine3d link_from_object =
        base_from_link.inverse(Eigen::Isometry) * poseOn(base, *body.frame).fixed_from_frame.affine;
    if (body.frame_from_body) link_from_object = link_from_object * *body.frame_from_body;
    if (body.held) link_from_object = body.held->link_from_body;
    if (!link_from_object.matrix().allFinite()) {
      problem = describe(TransformProblem::kPoseNotFinite, tf_.name(*body.frame),
                         tf_.name(scene_.target));
      return result;
    }
    result.body = trees_.bodyOf(*body.object);
    for (BodyShape& shape : result.body.shapes)
      shape.shape.link_from_shape = link_from_object * shape.shape.link_from_shape;
    return result;
  }

  /// The pose of `frame` in `base` at the latest common time of the path between them.
  const FramePose& poseOn(Frame base, Frame frame) {
    const auto [tracker, is_new] = trackers_.try_emplace(base, tf_);
    if (is_new) tracker->second.setTarget(base, 0, scene_.now);
    return tracker->second.keep(frame);
  }

  std::string problemOn(Frame base, Frame frame) {
    return describe(poseOn(base, frame).problem, tf_.name(frame), tf_.name(base));
  }

  /// The frame in which the root and the frame of an object are located independently, each at its
  /// own latest time, because the base may have driven on since the object's frame was sent. It is
  /// the nearest common ancestor of both. If that is on the robot, as for what a camera of the
  /// robot saw, it is the fixed frame; if that is on the robot, too, the topmost frame above the
  /// root.
  Frame groundOf(Frame root, Frame frame) const {
    const std::vector<Frame> way = wayUp(tf_, root);
    const Frame meet = climb(tf_, frame, [&way](Frame at) {
      return std::find(way.begin(), way.end(), at) != way.end();
    });
    if (!linkAbove(meet)) return meet;
    return linkAbove(scene_.target) ? way.back() : scene_.target;
  }

  /// The link whose frame is this frame or the nearest one above it, if any.
  std::optional<std::size_t> linkAbove(Frame frame) const {
    const auto is_link = [&](Frame at) { return links_.count(at) > 0; };
    const auto found = links_.find(climb(tf_, frame, is_link));
    return found != links_.end() ? std::make_optional(found->second) : std::nullopt;
  }

  /// The same for the object's own frame.
  std::optional<std::size_t> linkAbove(const PastBody& body) const {
    const auto frame = body.header ? body.header : body.frame;
    return frame ? linkAbove(*frame) : std::nullopt;
  }

  bool isFixedFrameMoved() const {
    const std::optional<std::size_t> above = linkAbove(scene_.target);
    return above && isMoved(*above);
  }

  /// For an object without a link above it: whether it is known to rest in the fixed frame, because
  /// it is a neighbour's box or because tf connects its frame. A refused marker has no frame.
  bool isKnownToRest(const PastBody& body) {
    if (body.object->is_neighbour) return true;
    const auto frame = body.header ? body.header : body.frame;
    if (!frame) return !body.object->frame.empty() && !isFixedFrameMoved();
    return tracker_.keep(*frame).problem != TransformProblem::kNoTransform;
  }

  /// An object that was placed once has stayed in the fixed frame since then. If the trajectory
  /// moves that frame, the object may stay behind.
  bool mayStayBehind(const PastBody& body, std::size_t link) const {
    return !body.header && body.frame_from_body && !body.held && isMoved(link);
  }

  /// The link of the robot to which the object is attached, or the link above its frame. An object
  /// that no link carries is beside the robot; so is one whose frame moves on a link that rests.
  Carrier carrierOf(const PastBody& body) {
    const std::optional<std::size_t> above = linkAbove(body);
    if (body.held) return {body.held->link};
    const auto attached = bodyOf(model_, {&body.bounded->name, std::nullopt});
    const auto& of_links = rigid_in_urdf_.of_links;
    if (attached && above && of_links[*above] == *attached) return {*above, body.is_carried_over};
    const bool is_known = above ? !mayStayBehind(body, *above) : isKnownToRest(body);
    const bool is_beside = !above || (!isMoved(*above) && !isMounted(body, *above));
    Carrier own{is_beside ? original_.root : *above, false, is_known, is_beside};
    if (is_beside) own.may_ride = above;
    if (!attached) return own;
    const auto link = std::find(of_links.begin(), of_links.end(), *attached);
    if (link == of_links.end()) return own;
    const auto held_by = static_cast<std::size_t>(link - of_links.begin());
    const bool is_one = rigid_.of_links[held_by] == rigid_.of_links[own.link];
    return {held_by, true, is_one};  // if not is_one, it moves with either of the two links
  }

  /// Why the place of an attached object on its link is not known; "" if it is known.
  std::string whyNotHeld(const PastBody& body, Frame link) {
    constexpr char kNotKnown[] =
        "where it is on the link to which it is attached is not known; let it follow a frame of "
        "that link, with stamp 0, or send it anew with a new stamp";
    if (body.is_carried_over) return kNotKnown;
    return areOneBody(link, *body.frame) ? "" : kNotKnown;
  }

  /// Whether only static transforms are between both frames.
  bool areOneBody(Frame a, Frame b) const {
    const std::vector<Frame> edges = edgesBetween(tf_, a, b);
    return std::all_of(edges.begin(), edges.end(),
                       [&](Frame frame) { return !tf_.hasParent(frame) || tf_.isStatic(frame); });
  }

  /// Whether the object's own frame is the frame of the link or static relative to it.
  bool isMounted(const PastBody& body, std::size_t link) const {
    const auto frame = body.header ? body.header : body.frame;
    return areOneBody(*scene_.robot_frames[link], *frame);
  }

  bool isMoved(std::size_t link) const {
    return rigid_.of_links[link] != rigid_.of_links[original_.root];
  }

  bool moves(std::size_t body) const { return isMoved(result_.bodies[body].link); }

  /// Two bodies at rest are no pair, so that many objects make few pairs.
  void addPairs(const PathLimits& limits) {
    const std::size_t count = result_.bodies.size();
    is_incomplete_.assign(count, false);
    for (std::size_t mover = 0; mover < count; ++mover) {
      if (!moves(mover)) continue;
      checkTime(limits);
      for (std::size_t other = 0; other < count; ++other) {
        const bool was_seen = other < mover && moves(other);
        if (!was_seen && isMovingPair(mover, other)) addPair(mover, other, limits);
      }
    }
    for (const std::size_t stray : strays_)
      addStray(stray, limits);
    std::sort(result_.pairs.begin(), result_.pairs.end());
    nameIncomplete();
  }

  static void checkTime(const PathLimits& limits) {
    if (limits.is_over()) throw std::runtime_error("there was no time to compare all bodies");
  }

  void addPair(std::size_t first, std::size_t second, const PathLimits& limits) {
    result_.pairs.emplace_back(std::minmax(first, second));
    for (const std::size_t body : {first, second})
      is_incomplete_[body] = is_incomplete_[body] || !result_.bodies[body].is_whole;
    if (result_.pairs.size() > limits.max_pairs)
      throw std::runtime_error("the trajectory moves more than " +
                               std::to_string(limits.max_pairs) +
                               " pairs of bodies; leave some out with ~ignore_pairs");
  }

  /// A stray may move with any link, so nothing about it can be proven. One pair with it suffices
  /// to report that.
  void addStray(std::size_t stray, const PathLimits& limits) {
    checkTime(limits);
    for (std::size_t other = 0; other < members_.size() && !is_incomplete_[stray]; ++other) {
      if (other != stray && isPair(model_, members_[stray], members_[other]))
        addPair(stray, other, limits);
    }
  }

  void nameIncomplete() {
    for (std::size_t i = 0; i < result_.bodies.size(); ++i) {
      const std::string& name = result_.names[i];
      const bool is_named = !result_.incomplete.empty() && result_.incomplete.back() == name;
      if (!is_incomplete_[i] || is_named) continue;
      if (result_.incomplete.empty()) result_.problem = name + ": " + problems_[i];
      result_.incomplete.push_back(name);
    }
  }

  bool isMovingPair(std::size_t i, std::size_t j) const {
    const std::size_t first = rigid_.of_links[result_.bodies[i].link];
    const std::size_t second = rigid_.of_links[result_.bodies[j].link];
    return first != second && isPair(model_, members_[i], members_[j]);
  }

  PastScene& scene_;
  const Model& model_;
  const Robot& original_;
  TransformBuffer& tf_;
  FrameTracker tracker_;
  std::map<Frame, FrameTracker> trackers_;  ///< by their target frame
  const PathTrees& trees_;
  std::map<Frame, std::size_t> links_;  ///< index in the robot of the link of each frame
  const RigidBodies rigid_in_urdf_;
  RigidBodies rigid_;                  ///< with all joints fixed that rest
  std::vector<PairMember> members_;    ///< one per body
  std::vector<std::string> problems_;  ///< one per body: why it is incomplete, or ""
  std::vector<std::size_t> strays_;    ///< bodies whose carrier is not known
  std::vector<bool> is_incomplete_;    ///< one per body: whether it is in a pair and not whole
  PathScene result_;
};

}  // namespace

BoxRequest pathRequest() {
  BoxRequest request;
  request.has_robot_frames = true;
  request.neighbours_follow = true;
  return request;
}

PathScene pathScene(PastScene& scene, const std::set<std::string>& joints, const PathTrees& trees,
                    const PathLimits& limits) {
  return SceneMaker(scene, trees).make(joints, limits);
}

}  // namespace link_bounds
