// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes choose the pairs. A search that begins where the last one of the pair ended shows whether
// it is too far away; a search without memory gives the numbers, so that these do not depend on the
// poses before.
#include "robot/posed/posed_robot.h"

#include <set>

#include "link_bounds/robot/urdf/kinematics.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/urdf/simple_joints.h"

namespace link_bounds {
namespace {

/// Max amount by which a search without memory proves less than one with a memory [m]: the accuracy
/// of both, and rounding.
const double kDoubt = DistanceGoal().accuracy * 1.001;

std::vector<bool> pairsOf(const Robot& robot, const BoundedRobot& bounded) {
  const RigidBodies rigid = rigidBodies(robot);
  const std::size_t count = bounded.links.size();
  std::vector<bool> result(count * count, false);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b)
      result[a * count + b] = !areJoined(rigid, bounded.indices[a], bounded.indices[b]);
  }
  return result;
}

}  // namespace

PosedRobot::PosedRobot(const Robot& robot, const BoundedRobot& bounded)
    : robot_(withSimpleJoints(robot)),
      bounded_(bounded),
      leads_(leadsOf(robot_)),
      are_pairs_(pairsOf(robot, bounded)),
      root_from_links_(bounded.links.size()),
      boxes_(bounded.links),
      is_placed_(bounded.links.size(), false) {
  for (std::size_t i = 0; i < bounded.bodies.size(); ++i)
    distances_.set(i, std::make_shared<const Body>(bounded.bodies[i]));
}

void PosedRobot::move(std::vector<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (robot_.joints[i].mimic)
      values[i] = leads_[i].factor * values[leads_[i].leader] + leads_[i].offset;
  }
  const std::vector<Eigen::Isometry3d> poses = linkPoses(robot_, values);
  std::vector<MovedLink> moved;
  boxed_.clear();
  search_boxes_.clear();
  for (std::size_t i = 0; i < bounded_.links.size(); ++i) {
    root_from_links_[i] = Eigen::Affine3d(poses[bounded_.indices[i]]);
    moved.push_back({i, &root_from_links_[i]});
  }
  boxes_.update(moved);
  for (std::size_t i = 0; i < bounded_.links.size(); ++i) {
    if (!boxes_.box(i)) continue;
    boxed_.push_back(i);
    search_boxes_.push_back(*boxes_.box(i));
  }
  is_placed_.assign(bounded_.links.size(), false);
}

Aabb PosedRobot::robotBox() const {
  Aabb result;
  for (const Aabb& box : search_boxes_)
    result.extend(box);
  return result;
}

bool PosedRobot::hasPairs() const {
  for (const std::size_t a : boxed_) {
    for (const std::size_t b : boxed_) {
      if (are_pairs_[a * bounded_.links.size() + b]) return true;
    }
  }
  return false;
}

/// Places only links that are compared, because a pose costs as much as a search that boxes decide.
void PosedRobot::place(std::size_t link) {
  if (is_placed_[link]) return;
  distances_.move(link, root_from_links_[link]);
  is_placed_[link] = true;
}

bool PosedRobot::isSurelyBeyond(std::size_t first, std::size_t second, double limit) {
  distances_.setGoal({DistanceGoal().accuracy, limit + kDoubt});
  const std::optional<BodyDistance> distance = distances_.find(first, second);
  return distance && distance->lower > limit + kDoubt;
}

PoseDistances PosedRobot::distances(double limit, const Wanted& wanted) {
  PoseDistances result;
  std::set<std::size_t> unmeasured;
  const auto are_compared = [this](std::size_t first, std::size_t second) {
    return are_pairs_[boxed_[first] * bounded_.links.size() + boxed_[second]];
  };
  search_.find(search_boxes_, {limit}, are_compared, near_);
  for (const BoxPair& pair : near_.compared) {
    const std::size_t a = boxed_[pair.first];
    const std::size_t b = boxed_[pair.second];
    place(a);
    place(b);
    if (isSurelyBeyond(a, b, wanted ? wanted(a, b) : limit)) continue;
    const std::optional<BodyDistance> distance = distances_.findOnce(a, b, limit);
    if (distance && distance->lower <= limit) result.pairs.push_back({a, b, *distance});
    if (distance) continue;
    for (const std::size_t link : {a, b}) {
      if (!distances_.findOnce(link, link, limit)) unmeasured.insert(link);
    }
  }
  distances_.forgetUnused();
  result.unmeasured.assign(unmeasured.begin(), unmeasured.end());
  return result;
}

}  // namespace link_bounds
