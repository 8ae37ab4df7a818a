// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Climbs the tf path of each body. The motion of an edge is computed once per stamp.
#include "world/stopping/body_ways.h"

#include <algorithm>

#include "world/tf/frame_paths.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

std::int64_t windowOf(const Parameters& parameters) {
  constexpr double kMaxWindow = 10;  // s, length of the tf history
  return static_cast<std::int64_t>(std::min(parameters.velocity_window, kMaxWindow) * 1e9);
}

WayJoint placed(WayJoint joint, const Eigen::Isometry3d& frame) {
  joint.place.origin = frame * joint.place.origin;
  joint.place.axis = frame.linear() * joint.place.axis;
  return joint;
}

/// Time between the stamp and the nearest sample of the edge [s].
double gapAt(const EdgeHistory& history, std::int64_t stamp) {
  const std::vector<const EdgeSample*> samples = history.between(stamp, stamp);
  std::int64_t gap = samples.empty() ? 0 : EdgeHistory::kLength;
  for (const EdgeSample* sample : samples)
    gap = std::min(gap, std::abs(stamp - sample->stamp));
  return static_cast<double>(gap) / 1e9;
}

/// Converts a report of the leader to one of the joint that mimics it.
void follow(const Lead& lead, JointReport& report) {
  report.position = lead.factor * report.position + lead.offset;
  if (report.velocity) *report.velocity *= lead.factor;
}

}  // namespace

BodyWays::BodyWays(PastScene& scene, const StopRules& rules, WayPurpose purpose,
                   const JointStates* states)
    : scene_(scene),
      tf_(scene.excerpt.buffer()),
      rules_(rules),
      purpose_(purpose),
      states_(states),
      window_(windowOf(rules.model().parameters)),
      tracker_(tf_) {
  tracker_.setTarget(scene.target, rules.model().parameters.timeout, scene.now);
  fixed_problem_ = whyFixedFrameMoves();
}

/// The frame with which a body moves. An attached object moves with its own frame if that belongs
/// to the rigid body of its link, else with any frame that does. Nothing if tf has no such frame.
std::optional<BodyWays::Frame> BodyWays::moverOf(const PastBody& body) const {
  const auto rigid_body = body.link ? std::nullopt : rules_.bodyOfObject(body.bounded->name);
  if (!rigid_body) return body.frame;
  const auto is_of_body = [&](Frame frame) {
    const auto link = rules_.linkOf(tf_.name(frame));
    return link && rules_.bodyOfLink(*link) == *rigid_body;
  };
  if (is_of_body(*body.frame)) return body.frame;
  for (Frame frame = 0; frame < tf_.size(); ++frame) {
    if (is_of_body(frame)) return frame;
  }
  return std::nullopt;
}

/// Why an attached object may be, or may come to be, elsewhere on its link; "" if it cannot.
std::string BodyWays::whyNotHeld(const PastBody& body, Frame mover, const FramePose& start,
                                 std::int64_t pose_stamp) const {
  if (mover == *body.frame) return "";
  const std::string remedy = "; let it follow a frame of that link, with stamp 0";
  if (body.is_outdated && start.stamp != 0)
    return "its place may be of a time before the clock jumped back" + remedy;
  if (start.stamp != 0 && start.stamp != pose_stamp)
    return "its place is of another time than that of the link to which it is attached" + remedy;
  if (body.frame_from_body && *body.frame == scene_.target) return "";
  for (const Frame edge : edgesBetween(tf_, mover, *body.frame)) {
    if (tf_.hasParent(edge) && !isRigid(edge))
      return "it follows frame \"" + tf_.name(*body.frame) +
             "\", which may move against the link to which it is attached" + remedy;
  }
  return "";
}

BodyWay BodyWays::find(const PastBody& body) {
  BodyWay way;
  const FramePose& own = tracker_.keep(*body.frame);
  if (own.problem != TransformProblem::kNone) {
    way.problem = describe(own.problem, tf_.name(*body.frame), scene_.frameName());
    return way;
  }
  const bool was_placed = body.frame_from_body && *body.frame == scene_.target;
  const std::int64_t pose_stamp = was_placed ? body.stamp : own.stamp;
  way.stamp = olderStamp(pose_stamp, body.stamp);
  way.pose = own.fixed_from_frame.affine;
  if (body.frame_from_body)
    way.pose = was_placed ? *body.frame_from_body : way.pose * *body.frame_from_body;
  const std::optional<Frame> mover = moverOf(body);
  if (!mover) {
    way.problem = "tf has no frame of the link to which it is attached";
    return way;
  }
  // A copy, because the next keep() may invalidate the reference.
  const FramePose start = tracker_.keep(*mover);
  if (start.problem != TransformProblem::kNone) {
    way.problem = describe(start.problem, tf_.name(*mover), scene_.frameName());
    return way;
  }
  way.has_pose = true;
  way.known = std::min(knownSince(*body.frame, way.stamp), knownSince(*mover, way.stamp));
  way.problem = whyNotHeld(body, *mover, start, pose_stamp);
  if (!way.problem.empty()) {
    way.is_placed = !isContact();
    return way;
  }
  bool is_carried = false;
  if (isContact() || start.stamp != 0 || *mover == scene_.target || edgeInDoubt(*mover))
    is_carried = climb(*mover, start, way);
  if (!way.problem.empty() && is_carried) return way;
  // An object that was placed once stands still, even if a fixed frame on the robot moves.
  if (body.frame_from_body && *mover == scene_.target)
    way.problem = whyStrangerMoves(scene_.target, 0);
  if (isContact() && body.object && body.object->is_neighbour && body.object->stamp != 0)
    way.problem = "it belongs to another node, and nothing is known of how fast it moves";
  way.is_placed = !isContact() || way.problem.empty();
  return way;
}

/// The stamp, or the present time if that is earlier. Earlier still by the max lead of the clocks
/// that stamp the edges up to the root. Edges that cannot move do not count: some publishers date
/// these ahead on purpose.
std::int64_t BodyWays::knownSince(Frame frame, std::int64_t stamp) const {
  std::int64_t known = std::min(stamp, nanosecondsOf(scene_.now));
  for (const Frame edge : wayUp(tf_, frame)) {
    const auto link = rules_.linkOf(tf_.name(edge));
    if (link && !rules_.jointAbove(*link)) break;  // contacts ignore all edges above the root
    if (!tf_.hasParent(edge) || isRigid(edge) || tf_.isStatic(edge)) continue;
    const std::int64_t ahead = tf_.newest(edge) - tf_.received(edge);
    known = std::min(known, stamp - std::max<std::int64_t>(ahead, 0));
  }
  return known;
}

/// An edge between the frame and the fixed frame that isStaticInDoubt(), if there is any.
std::optional<TransformBuffer::Frame> BodyWays::edgeInDoubt(Frame frame) const {
  for (const Frame edge : edgesBetween(tf_, scene_.target, frame)) {
    if (tf_.isStaticInDoubt(edge)) return edge;
  }
  return std::nullopt;
}

/// Collects the joints from the frame up to the fixed frame; or up to the root, and then the motion
/// of the root as a base. For contacts, ends at the root. True if a link carries the body.
bool BodyWays::climb(Frame frame, const FramePose& start, BodyWay& way) {
  const Frame first = frame;
  Eigen::Isometry3d pose;
  pose.matrix() = start.fixed_from_frame.affine.matrix();
  std::string below;  // why an edge below the first link is not rigid
  bool is_carried = false;
  for (std::size_t steps = 0;; ++steps) {
    const std::optional<std::size_t> link = rules_.linkOf(tf_.name(frame));
    is_carried = is_carried || link;
    if (is_carried && way.problem.empty()) way.problem = below;
    const bool is_root = link && !rules_.jointAbove(*link);
    if (!way.problem.empty() || (!isContact() && frame == scene_.target)) break;
    if (is_root) {
      if (!isContact())
        way.problem =
            fixed_problem_.empty() ? addBase(start.stamp, frame, way.joints) : fixed_problem_;
      else if (!groundProblem().empty())
        moveInto(pose, way);
      break;
    }
    if (!tf_.hasParent(frame) || steps > tf_.size()) {
      if (is_carried)
        way.problem = "tf does not lead from frame \"" + tf_.name(frame) + "\" to the robot's root";
      break;
    }
    const EdgeMotion& motion = motionOf(frame, start.stamp);
    if (link) way.problem = motion.problem;
    if (!link && below.empty()) below = motion.problem;
    const Eigen::Isometry3d parent = pose * motion.parent_from_child.inverse();
    if (motion.joint) {
      const bool is_base = motion.joint->place.kind == MovingJoint::Kind::kFree;
      way.joints.push_back(placed(*motion.joint, is_base ? parent : pose));
    }
    pose = parent;
    frame = tf_.parent(frame);
  }
  std::reverse(way.joints.begin(), way.joints.end());
  if (!is_carried) way.problem = whyStrangerMoves(first, start.stamp);
  return is_carried;
}

/// For stopping boxes: why objects that stand may move in the fixed frame. For contacts: why the
/// robot's root may move relative to them. "" if not.
const std::string& BodyWays::groundProblem() {
  if (!ground_problem_) ground_problem_ = isContact() ? whyRootMoves() : whyGroundMoves();
  return *ground_problem_;
}

/// Converts the way to the frame of the root. There, poses of different stamps can be compared even
/// if the root moves.
void BodyWays::moveInto(const Eigen::Isometry3d& root, BodyWay& way) {
  const Eigen::Isometry3d inverse = root.inverse();
  way.pose.matrix() = (inverse * way.pose).matrix();
  for (WayJoint& joint : way.joints)
    joint = placed(joint, inverse);
}

/// Why a body that no link carries may move; "" if it stands. Its speed limit and its braking are
/// never known.
std::string BodyWays::whyStrangerMoves(Frame frame, std::int64_t stamp) {
  const std::string& ground = groundProblem();
  if (!ground.empty() || frame == scene_.target) return ground;
  if (const auto edge = edgeInDoubt(frame)) return edgeSamples(tf_, *edge, stamp, window_).problem;
  if (stamp == 0) return "";
  const std::string what = "its frame \"" + tf_.name(frame) + "\" moves, and nothing is known of ";
  if (isContact()) return what + "how fast";
  const EdgeSamples samples = pathSamples(tf_, scene_.target, frame, stamp, window_);
  if (!samples.problem.empty()) return samples.problem;
  if (isStill(samples.poses)) return "";
  return what + "how it brakes";
}

/// Why a fixed frame on the robot moves relative to a frame above it; "" if not. If it moves, all
/// objects that stand move in it.
std::string BodyWays::whyGroundMoves() const {
  bool is_on_robot = false;
  for (const Frame frame : wayUp(tf_, scene_.target)) {
    if (!tf_.hasParent(frame)) break;
    is_on_robot = is_on_robot || rules_.linkOf(tf_.name(frame));
    const EdgeSamples samples = edgeSamples(tf_, frame, tf_.newest(frame), window_);
    if (is_on_robot && !(samples.problem.empty() && isStill(samples.poses))) {
      return "the fixed frame \"" + scene_.frameName() + "\" moves with frame \"" +
             tf_.name(frame) +
             "\", or it is not known whether it does; choose a ~fixed_frame that stands";
    }
  }
  return "";
}

/// Why the root may move relative to objects that stand; "" if it cannot. Checks the edges between
/// the root and the fixed frame; for a fixed frame on the robot, all edges from it up to the top of
/// tf, because objects may stand in any frame above.
std::string BodyWays::whyRootMoves() const {
  std::vector<Frame> edges;
  bool is_on_robot = false;
  for (const Frame frame : wayUp(tf_, scene_.target)) {
    is_on_robot = is_on_robot || rules_.linkOf(tf_.name(frame));
    if (is_on_robot) edges.push_back(frame);
  }
  for (Frame frame = 0; frame < tf_.size() && edges.empty(); ++frame) {
    const auto link = rules_.linkOf(tf_.name(frame));
    if (link && !rules_.jointAbove(*link)) edges = edgesBetween(tf_, scene_.target, frame);
  }
  for (const Frame frame : edges) {
    if (tf_.hasParent(frame) && !isRigid(frame))
      return "the robot moves by the transform of frame \"" + tf_.name(frame) +
             "\", and nothing is known of how fast";
  }
  return "";
}

/// Whether the edge cannot move: a static edge without doubt, or a fixed joint that stands in tf.
bool BodyWays::isRigid(Frame child) const {
  if (tf_.isStatic(child)) return !tf_.isStaticInDoubt(child);
  const auto link = rules_.linkOf(tf_.name(child));
  const auto above = link ? rules_.jointAbove(*link) : std::nullopt;
  return above && rules_.rule(*above).joint->motion == Motion::kNone && isStillInTf(child);
}

/// Whether the edge stood during all of the copied tf history, however rarely it is sent.
bool BodyWays::isStillInTf(Frame child) const {
  const EdgeHistory* const history = tf_.history(child);
  if (!history || history->samples().isEmpty()) return false;
  const SampleRing& samples = history->samples();
  std::vector<TimedPose> poses(samples.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (samples[i].parent != samples.newest().parent ||
        !toIsometry(samples[i].parent_from_child, poses[i].pose))
      return false;
  }
  return isStill(poses);
}

std::string BodyWays::addBase(std::int64_t stamp, Frame root, std::vector<WayJoint>& joints) {
  const auto [entry, is_new] = bases_.try_emplace({root, stamp});
  BaseMotion& motion = entry->second;
  if (is_new) motion = findBase(stamp, root);
  if (!motion.joint) return motion.problem;
  joints.push_back({*motion.joint, {}, {}});
  if (motion.more > 0) {
    MovingJoint more{MovingJoint::Kind::kFree, motion.joint->origin, motion.joint->axis};
    more.distance = motion.more;
    more.spread = M_PI;
    joints.push_back({more, {}, {}});
  }
  return motion.problem;
}

BaseMotion BodyWays::baseIn(Frame frame, std::int64_t stamp, Frame root) const {
  const EdgeSamples samples = pathSamples(tf_, frame, root, stamp, window_);
  if (!samples.problem.empty()) return {{}, 0, samples.problem};
  return baseMotion(samples.poses, window_, rules_.model().parameters);
}

/// Covers the motion of the root in the fixed frame and in each frame between the two. The fixed
/// frame alone is not enough: if a localisation shifts its frame against the motion of the base,
/// the base seems to stand in the fixed frame.
BaseMotion BodyWays::findBase(std::int64_t stamp, Frame root) const {
  BaseMotion motion = baseIn(scene_.target, stamp, root);
  for (const Frame child : edgesBetween(tf_, root, scene_.target)) {
    if (tf_.isStatic(child)) continue;
    for (const Frame frame : {child, tf_.parent(child)}) {
      const auto pose = tf_.pose(scene_.target, frame, stamp);
      Eigen::Isometry3d in_fixed;
      if (frame == root || frame == scene_.target || !pose || !toIsometry(*pose, in_fixed))
        continue;
      motion = around(std::move(motion), baseIn(frame, stamp, root), in_fixed);
    }
  }
  return motion;
}

const BodyWays::EdgeMotion& BodyWays::motionOf(Frame child, std::int64_t stamp) {
  const auto [entry, is_new] = motions_.try_emplace({child, stamp});
  if (is_new) entry->second = findMotion(child, stamp);
  return entry->second;
}

/// An edge that is no joint of the robot must not move; for contacts, it must be static.
BodyWays::EdgeMotion BodyWays::findMotion(Frame child, std::int64_t stamp) {
  EdgeMotion result;
  EdgeSample scratch;
  const EdgeSample* const edge = tf_.at(child, stamp, scratch);
  if (!edge || !toIsometry(edge->parent_from_child, result.parent_from_child)) {
    result.problem = "frame \"" + tf_.name(child) +
                     "\" has no transform at that time, or its quaternion is not of length 1; "
                     "correct its publisher";
    return result;
  }
  const std::optional<std::size_t> link = rules_.linkOf(tf_.name(child));
  const std::optional<std::size_t> joint = link ? rules_.jointAbove(*link) : std::nullopt;
  if (tf_.isStaticInDoubt(child)) {
    result.problem = edgeSamples(tf_, child, stamp, window_).problem;
  } else if (joint) {
    addJoint(child, *joint, stamp, result);
  } else if (!tf_.isStatic(child)) {
    const EdgeSamples samples = edgeSamples(tf_, child, stamp, window_);
    result.problem = samples.problem;
    if (isContact() || (samples.problem.empty() && !isStill(samples.poses)))
      result.problem = "frame \"" + tf_.name(child) + "\" moves, and it is no link of the robot";
  }
  return result;
}

void BodyWays::addJoint(Frame child, std::size_t index, std::int64_t stamp, EdgeMotion& edge) {
  const JointRule& rule = rules_.rule(index);
  const Joint& joint = *rule.joint;
  const std::string& parent = rules_.frameName(joint.parent);
  if (tf_.name(tf_.parent(child)) != parent) {
    edge.problem = "tf has frame \"" + tf_.name(child) + "\" below \"" +
                   tf_.name(tf_.parent(child)) + "\", not below \"" + parent +
                   "\" as the robot description";
    return;
  }
  if (!hasValue(joint.motion) || joint.axis.isZero(0)) {
    addFreeJoint(child, joint, stamp, edge);
    return;
  }
  if (tf_.isStatic(child)) {
    edge.problem = whyMisfit(joint, fitOf(joint, edge.parent_from_child));
    return;
  }
  WayJoint moving{
      {joint.motion == Motion::kRotation ? MovingJoint::Kind::kTurn : MovingJoint::Kind::kSlide,
       Eigen::Vector3d::Zero(), joint.axis},
      index,
      {}};
  if (isContact()) {
    edge.problem = whyMisfit(joint, fitOf(joint, edge.parent_from_child));
    if (edge.problem.empty()) edge.problem = rule.why_no_speed_limit;
    moving.between = gapAt(*tf_.history(child), stamp);
  }
  if (!edge.problem.empty()) return;
  moving.state = stateOf(child, rule, stamp, edge.parent_from_child);
  moving.is_speed_known = moving.state.problem.empty();
  if (isContact()) {
    if (!moving.is_speed_known) moving.state.value = fitOf(joint, edge.parent_from_child).value;
  } else {
    edge.problem = moving.is_speed_known ? rule.why_no_stop : moving.state.problem;
  }
  if (edge.problem.empty()) edge.joint = moving;
}

/// For fixed, planar and floating joints, and for joints without an axis.
void BodyWays::addFreeJoint(Frame child, const Joint& joint, std::int64_t stamp, EdgeMotion& edge) {
  if (tf_.isStatic(child)) return;
  const bool is_base = joint.motion == Motion::kPlanar || joint.motion == Motion::kFloating;
  const std::string moves = "joint \"" + joint.name + "\" moves, but it is fixed";
  if (isContact()) {
    if (is_base)
      edge.problem = rules_.rule(*rules_.jointAbove(joint.child)).why_no_speed_limit;
    else if (!isStillInTf(child))
      edge.problem = moves;
    return;
  }
  const EdgeSamples samples = edgeSamples(tf_, child, stamp, window_);
  edge.problem = samples.problem;
  if (!edge.problem.empty()) return;
  if (!is_base) {
    if (!isStill(samples.poses)) edge.problem = moves;
    return;
  }
  const BaseMotion base = baseMotion(samples.poses, window_, rules_.model().parameters);
  if (!base.problem.empty()) edge.problem = joint.name + ": " + base.problem;
  if (!base.joint) return;
  edge.joint = WayJoint{*base.joint, {}, {}};
  // The base turns about its position at the stamp; the last sample may be later.
  edge.joint->place.origin = edge.parent_from_child.translation();
}

/// From /joint_states if it has the joint, or else the joint that it mimics; otherwise from tf.
JointState BodyWays::stateOf(Frame child, const JointRule& rule, std::int64_t stamp,
                             const Eigen::Isometry3d& pose) const {
  if (states_) {
    for (const Joint* joint : {rule.joint, rule.leader}) {
      auto reports = states_->reports(joint->name, stamp, window_);
      if (!reports) continue;
      JointState unknown;
      unknown.problem = unwrap(*joint, *reports);
      if (!unknown.problem.empty()) return unknown;
      std::optional<JointReport> before = states_->lastBefore(joint->name, stamp - window_);
      if (joint != rule.joint) {
        for (JointReport& report : *reports)
          follow(rule.lead, report);
        if (before) follow(rule.lead, *before);
      }
      return jointState(*rule.joint, pose, *reports, stamp, window_, before);
    }
  }
  const EdgeSamples samples = edgeSamples(tf_, child, stamp, window_);
  if (samples.problem.empty()) return jointState(*rule.joint, pose, samples, window_);
  JointState unknown;
  unknown.problem = samples.problem;
  return unknown;
}

/// Why the fixed frame moves with a joint of the robot; "" if not. The root would then move in the
/// fixed frame, in a way that no parameter describes.
std::string BodyWays::whyFixedFrameMoves() const {
  for (const Frame frame : wayUp(tf_, scene_.target)) {
    const auto link = rules_.linkOf(tf_.name(frame));
    const auto above = link ? rules_.jointAbove(*link) : std::nullopt;
    if (above && rules_.rule(*above).joint->motion != Motion::kNone) {
      return "the fixed frame \"" + scene_.frameName() + "\" moves with joint \"" +
             rules_.rule(*above).joint->name + "\"; choose a ~fixed_frame that no joint moves";
    }
  }
  return "";
}

BoxRequest wayRequest(const Parameters& parameters) {
  BoxRequest request;
  request.span = windowOf(parameters);
  request.neighbours_follow = true;
  return request;
}

WayBoxes wayBoxes(
    PastScene& scene, BodyWays& ways,
    const std::function<std::optional<Aabb>(const PastBody&, const BodyWay&)>& box_of) {
  auto moment = std::make_shared<Moment>();
  moment->model = scene.model;
  moment->header.frame_id = scene.frameName();
  WayBoxes result;
  std::size_t incomplete = 0;
  for (const PastBody& body : scene.bodies) {
    BodyWay way;
    std::optional<Aabb> box;
    if (body.frame) way = ways.find(body);
    if (way.is_placed) {
      box = box_of(body, way);
      if (box && !(box->min().allFinite() && box->max().allFinite())) box.reset();
      if (!box) way.problem = "its box is too large for numbers";
    }
    if (body.frame && !way.has_pose) result.have_poses = false;
    if (body.incomplete || !way.problem.empty()) {
      const std::string& reason = way.problem.empty() ? body.reason : way.problem;
      if (incomplete++ == 0) result.problem = body.bounded->name + ": " + reason;
      moment->addIncomplete(body.bounded->name, body.link);
    }
    if (!box) continue;
    moment->bodies.push_back({body.link, body.object, way.stamp, *box, way.pose});
    moment->header.stamp = std::max(moment->header.stamp, timeFrom(way.stamp));
    result.ways.push_back(std::move(way));
  }
  if (incomplete > 1)
    result.problem += "; incomplete are " + std::to_string(incomplete - 1) + " more";
  result.moment = std::move(moment);
  return result;
}

}  // namespace link_bounds
