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

/// A robot at its last joint values. Its results depend on these values alone; earlier ones only
/// make it faster. Not thread-safe; each thread may have its own for the same robot.
class PosedRobot {
 public:
  /// The distance from which on two links need not be measured [m], see distances().
  using Wanted = std::function<double(std::size_t first, std::size_t second)>;

  /// `bounded`, which is that of `robot`, must outlive this object. Throws JointError for mimic
  /// joints that follow each other in a circle or follow no joint, and what withSimpleJoints()
  /// throws.
  PosedRobot(const Robot& robot, const BoundedRobot& bounded);

  /// The robot, with floating and planar joints as joints of one value each, see
  /// withSimpleJoints().
  const Robot& robot() const { return robot_; }

  /// One value per joint of robot() [rad or m], finite; those of mimic joints are replaced by what
  /// they follow. Throws JointError if a joint without an axis has another value than 0.
  void move(std::vector<double> values);

  /// The box of a link of BoundedRobot, in the frame of the root link. Nothing before the first
  /// move(), and for a link without a shape or a finite box.
  const std::optional<Aabb>& box(std::size_t link) const { return boxes_.box(link); }

  /// The box around all links; empty if no link has a box.
  Aabb robotBox() const;

  /// Whether any two links with a box are a pair: not of one rigid body, nor joined by one joint.
  bool hasPairs() const;

  /// All pairs whose proven distance is at most `limit` [m], each to DistanceGoal().accuracy. Needs
  /// BoundedRobot::bodies. With `wanted`, whose results must not exceed `limit`, a pair may be
  /// missing that is proven to be farther apart than its result. This saves measuring such pairs.
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
  std::vector<Aabb> search_boxes_;  ///< boxes of the links in boxed_
  std::vector<bool> is_placed_;     ///< by link: placed in distances_
  BodyDistances distances_;
};

}  // namespace link_bounds
