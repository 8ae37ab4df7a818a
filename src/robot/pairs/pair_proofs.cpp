// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/pair_proofs.h"

#include <algorithm>
#include <cmath>

#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/pairs/pair_queue.h"
#include "robot/urdf/simple_joints.h"

namespace link_bounds {
namespace {

constexpr const char* kVerdicts[kVerdictCount] = {
    "NEVER", "ALWAYS", "TOUCHING", "CONTACT_SAMPLED", "SOMETIMES", "UNDECIDED", "ADJACENT"};

/// Which links are joined so closely that MoveIt never checks them for collisions. Refers to the
/// robot. Links are given by their index in BoundedRobot::links.
///
/// Joints are sorted from the root outward, so a link whose joint comes later is never above the
/// other link.
class LinkNeighbours {
 public:
  LinkNeighbours(const Robot& robot, const BoundedRobot& bounded)
      : robot_(robot),
        links_(bounded.indices),
        rigid_(rigidBodies(robot)),
        joints_above_(robot.links.size(), 0),
        has_geometry_(robot.links.size(), false) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      joints_above_[robot.joints[j].child] = j + 1;
    for (const std::size_t link : links_)
      has_geometry_[link] = true;
  }

  /// True if fixed joints connect the two, over any number of links.
  bool areRigid(std::size_t first, std::size_t second) const {
    return rigid_.of_links[links_[first]] == rigid_.of_links[links_[second]];
  }

  /// True if no link with geometry is between the two, and at most one joint between them can move.
  /// The parts of a floating or planar joint count as one joint.
  bool areAdjacent(std::size_t first, std::size_t second) const {
    const auto isBetween = [&](std::size_t link) {
      return has_geometry_[link] && link != links_[first] && link != links_[second];
    };
    std::size_t a = links_[first];
    std::size_t b = links_[second];
    std::string counted;  // floating or planar joint that the last joint is a part of
    for (int movable = 0; a != b;) {
      std::size_t& lower = joints_above_[a] > joints_above_[b] ? a : b;
      if (isBetween(lower)) return false;
      const Joint& joint = robot_.joints[joints_above_[lower] - 1];
      lower = joint.parent;
      if (joint.motion == Motion::kNone) continue;
      if (joint.part_of.empty() || joint.part_of != counted) ++movable;
      if (movable > 1) return false;
      counted = joint.part_of;
    }
    return !isBetween(a);
  }

 private:
  const Robot& robot_;
  std::vector<std::size_t> links_;  ///< indices in Robot::links
  RigidBodies rigid_;
  std::vector<std::size_t> joints_above_;  ///< by link: index of the joint above it plus 1; 0: the
                                           ///< root
  std::vector<bool> has_geometry_;         ///< by link of the robot
};

/// The pairs that the report lists. Those of joined links are kAdjacent; the others have no verdict
/// yet.
std::vector<PairProof> chosenPairs(const Robot& robot, const BoundedRobot& bounded,
                                   PairChoice choice) {
  const LinkNeighbours neighbours(robot, bounded);
  std::vector<PairProof> pairs;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    for (std::size_t j = i + 1; j < bounded.links.size(); ++j) {
      PairProof pair;
      pair.first = i;
      pair.second = j;
      pair.is_rigid = neighbours.areRigid(i, j);
      if (pair.is_rigid && !choice.lists_rigid) continue;
      if ((pair.is_rigid || !choice.examines_adjacent) && neighbours.areAdjacent(i, j))
        pair.verdict = Verdict::kAdjacent;
      pairs.push_back(pair);
    }
  }
  return pairs;
}

Verdict verdictOf(const PairSearch& search, bool is_whole) {
  if (search.alwaysCollides()) return Verdict::kAlways;
  if (search.isFree() && is_whole) return Verdict::kNever;
  if (search.alwaysTouches()) return Verdict::kTouching;
  if (!search.collides()) return Verdict::kUndecided;
  const bool is_sampled = search.isSampled() && !search.hasFreePose();
  return is_sampled ? Verdict::kContactSampled : Verdict::kSometimes;
}

/// The pairs of one robot while they are searched.
class Prover {
 public:
  Prover(const Robot& robot, const BoundedRobot& bounded, const std::vector<JointRange>& ranges,
         const PairGoal& goal, std::vector<PairProof>& proofs)
      : robot_(robot), bounded_(bounded), ranges_(ranges), goal_(goal), proofs_(proofs) {}

  void prepare(const ProofControl& control) {
    for (const Body& body : bounded_.bodies) {
      if (control.is_over()) return;
      bodies_.push_back(pairBody(body));
    }
  }

  /// Null if a link has no shape or the range of a joint is not known.
  std::unique_ptr<PairSearch> begin(std::size_t pair) {
    PairProof& proof = proofs_[pair];
    const PairBody& first = bodies_[proof.first];
    const PairBody& second = bodies_[proof.second];
    if (first.body->shapes.empty() || second.body->shapes.empty()) return nullptr;
    JointPath path =
        jointPath(robot_, ranges_, bounded_.indices[proof.first], bounded_.indices[proof.second]);
    if (!path.unknown.empty()) {
      proof.reason = missingRanges(robot_, path.unknown);
      return nullptr;
    }
    return std::make_unique<PairSearch>(std::move(path), first, second, goal_);
  }

  void store(std::size_t pair, const PairSearch& search) {
    // Coordinates that are too large have no finite distance in any pose.
    if (!std::isfinite(search.nearest().upper)) return;
    PairProof& proof = proofs_[pair];
    const bool is_whole =
        bounded_.links[proof.first].isWhole() && bounded_.links[proof.second].isWhole();
    proof.verdict = verdictOf(search, is_whole);
    proof.nearest = search.nearest().upper;
    if (is_whole) proof.clearance = std::min(search.clearance(), proof.nearest);
    for (std::size_t i = 0; i < search.path().variables.size(); ++i) {
      const Joint& joint = robot_.joints[search.path().variables[i]];
      proof.pose[joint.name] = search.nearest().values[i];
    }
    proof.can_move = !search.path().variables.empty();
    for (const auto& [joint, value] : search.path().resting)
      proof.pose[robot_.joints[joint].name] = value;
    proof.has_free_pose = search.hasFreePose();
    proof.poses = search.poses();
  }

 private:
  const Robot& robot_;
  const BoundedRobot& bounded_;
  const std::vector<JointRange>& ranges_;
  const PairGoal goal_;
  std::vector<PairProof>& proofs_;
  std::vector<PairBody> bodies_;
};

}  // namespace

const char* toText(Verdict verdict) {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

std::vector<PairProof> provePairs(const Robot& robot, const BoundedRobot& bounded,
                                  const std::vector<JointRange>& ranges, const PairGoal& goal,
                                  const ProofControl& control, PairChoice choice) {
  std::vector<PairProof> proofs = chosenPairs(robot, bounded, choice);
  std::vector<std::size_t> examined;
  for (std::size_t pair = 0; pair < proofs.size(); ++pair) {
    if (proofs[pair].verdict != Verdict::kAdjacent) examined.push_back(pair);
  }
  Prover prover(robot, bounded, ranges, goal, proofs);
  prover.prepare(control);
  const PairWork work{
      [&](std::size_t pair) { return prover.begin(pair); },
      [&](std::size_t pair, const PairSearch& search) { prover.store(pair, search); }};
  PairQueue(examined, work, control).run();
  return proofs;
}

}  // namespace link_bounds
