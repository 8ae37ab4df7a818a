// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes and distances of a robot at any joint values, asked for many times.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/pairs/near_pairs.h"
#include "link_bounds/geometry/distance/body_distances.h"
#include "link_bounds/robot/robot_loader.h"
#include "robot/urdf/joint_ranges.h"

namespace link_bounds {

/// Two links by their indices in BoundedRobot::links, first < second.
struct LinkPairDistance {
  std::size_t first;
  std::size_t second;
  BodyDistance distance;  ///< in the frame of the root link
};

struct PoseDistances {
  std::vector<LinkPairDistance> pairs;  ///< sorted by first, then by second
  std::vector<std::size_t> unmeasured;  ///< links whose size and pose give no finite distance
};

/// A robot at its last joint values. What it gives depends on these alone, not on those before,
/// which only make it faster. Not thread-safe; any number of threads may have one of the same
/// robot.
class PosedRobot {
 public:
  /// How far apart two links need not be measured [m], see distances().
  using Wanted = std::function<double(std::size_t first, std::size_t second)>;

  /// `bounded`, which is that of `robot`, must live as long. Throws JointError for mimic joints
  /// that follow each other in a circle or follow no joint, and what withSimpleJoints() throws.
  PosedRobot(const Robot& robot, const BoundedRobot& bounded);

  /// With floating and planar joints as joints of one value each, see withSimpleJoints().
  const Robot& robot() const { return robot_; }

  /// One value per joint of robot() [rad or m], finite; those of mimic joints are replaced by what
  /// they follow. Throws JointError if a joint without an axis has another value than 0.
  void move(std::vector<double> values);

  /// Of the links of BoundedRobot, in the frame of the root link. Before the first move(), and for
  /// a link without a shape or a finite box, there is no box.
  const std::optional<Aabb>& box(std::size_t link) const { return boxes_.box(link); }

  /// Around all boxes; empty if there is none.
  Aabb robotBox() const;

  /// Whether any two links with a box are a pair: not of one rigid body, nor joined by one joint.
  bool hasPairs() const;

  /// All pairs whose proven distance is at most `limit` [m], each to DistanceGoal().accuracy. Needs
  /// BoundedRobot::bodies. With `wanted`, a pair may be missing that is proven to be farther apart
  /// than its result, which is then below `limit` or equal; measuring such pairs is saved.
  PoseDistances distances(double limit, const Wanted& wanted = nullptr);

 private:
  void place(std::size_t link);
  bool isSurelyBeyond(std::size_t first, std::size_t second, double limit);

  Robot robot_;
  const BoundedRobot& bounded_;
  std::vector<Lead> leads_;
  std::vector<bool> are_pairs_;  ///< by first * number of links + second
  std::vector<Eigen::Affine3d> root_from_links_;
  LinkBoxes boxes_;
  NearPairSearch search_;
  NearPairs near_;                  ///< of the last distances()
  std::vector<std::size_t> boxed_;  ///< links
  std::vector<Aabb> search_boxes_;  ///< theirs
  std::vector<bool> is_placed_;     ///< of each link, in distances_
  BodyDistances distances_;
};

}  // namespace link_bounds
