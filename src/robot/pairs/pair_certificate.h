// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Why two bodies stay apart or in contact, in steps that a program without this search can check.
#pragma once

#include <functional>
#include <iosfwd>

#include "link_bounds/geometry/distance/body_distances.h"
#include "robot/pairs/motion_bound.h"
#include "robot/pairs/pair_body.h"

namespace link_bounds {

/// What is certified for all poses: that the bodies are farther apart than `distance` [m] or, for a
/// contact, within it.
struct PairClaim {
  bool is_contact;
  double distance;
};

/// The box of a path's variables while the share of a motion is within `half` of `middle`.
using BoxOfShares = std::function<JointBox(double middle, double half)>;

/// Halves the box of all joint values until the claim is proven in each part. Refers to the bodies.
class PairCertificate {
 public:
  /// The claim must be weaker than what is proven. All ranges of the path must be known.
  PairCertificate(JointPath path, const PairBody& first, const PairBody& second, PairClaim claim);
  PairCertificate(const PairCertificate&) = delete;
  PairCertificate& operator=(const PairCertificate&) = delete;

  const JointPath& path() const { return path_; }

  /// Writes the tree as a JSON array, a box before its halves, and the half with smaller values
  /// first. An entry is the index of the variable that is halved, or the proof for the box. For a
  /// gap, the proof is a direction [x, y, z] from the first body to the second in the frame of the
  /// first; or a list of such directions, one per pair of shapes; or "mesh". For a contact, it is a
  /// point of the first body and one of the second, each in the frame of its body. Returns false,
  /// with a part of the tree, if there are too many boxes or `is_over` returns true.
  bool writeTree(const std::function<bool()>& is_over, std::ostream& out);

  /// The same for a motion, whose only variable is its share, from 0 to 1.
  bool writeTree(const BoxOfShares& box_of, const std::function<bool()>& is_over,
                 std::ostream& out);

 private:
  bool writeClosing(const JointBox& box, std::ostream& out);
  bool writeGap(std::ostream& out);
  bool writeContact(std::ostream& out);
  bool writeDirection(Eigen::Vector3d direction, const PairHull& first, const PairHull& second,
                      std::ostream& out) const;
  bool writeDirections(std::ostream& out) const;
  Eigen::Vector3d directionOf(const PairHull& first, const PairHull& second) const;
  double accuracy() const;
  bool areTrianglesApart();

  JointPath path_;
  const PairBody& first_;
  const PairBody& second_;
  PairClaim claim_;
  MotionBound motion_;
  PlacedPath placed_;
  BodyDistances distances_;
};

}  // namespace link_bounds
