// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far the triangles of two leaves are apart along directions that a search tries. This is in
// floats; the pairs that it leaves open are compared in doubles.
#pragma once

#include "geometry/distance/triangle_tree.h"

namespace link_bounds {

/// The corners of a triangle, in the coordinates of a search.
inline Triangle placed(const TriangleTree& tree, std::uint32_t triangle, const Placement& at) {
  Triangle corners = tree.corners(triangle);
  for (Eigen::Vector3d& corner : corners)
    corner = at.toSearch(corner);
  return corners;
}

/// A number for each triangle of a leaf. Where there are fewer, the last one is repeated.
using Lanes = Eigen::Array<float, kTrianglesPerLeaf, 1>;

/// A leaf in the axes of a search.
struct PlacedLeaf {
  /// A point or a vector for each triangle.
  struct Vectors {
    Lanes x, y, z;

    Lanes dot(const Vectors& other) const { return x * other.x + y * other.y + z * other.z; }
    Lanes dot(const Eigen::Vector3f& d) const { return x * d.x() + y * d.y() + z * d.z(); }
    Eigen::Vector3f of(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
  };

  void place(const TriangleTree& tree, std::uint32_t node, const Placement& at);

  Lanes farthest(const Eigen::Vector3f& d) const {
    return corners[0].dot(d).max(corners[1].dot(d)).max(corners[2].dot(d));
  }
  Lanes nearest(const Eigen::Vector3f& d) const {
    return corners[0].dot(d).min(corners[1].dot(d)).min(corners[2].dot(d));
  }

  std::uint32_t first = 0;  ///< index of the first triangle
  std::uint32_t count = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of the node's box
  /// Max |coordinate| of a corner, relative to the centre [m]. Infinite if floats might overflow;
  /// then the members below are not set.
  double size = 0;
  std::array<Vectors, 3> corners;  ///< relative to the centre
  Vectors normals;                 ///< of the planes; unit, or zero
  Lanes low, high;                 ///< of each triangle along its own normal, from the centre
};

/// The pairs of triangles of two leaves, which must outlive this object.
class LeafGaps {
 public:
  /// Looks along a unit direction. `rounding` bounds the error of a distance in doubles.
  LeafGaps(const PlacedLeaf& first, const PlacedLeaf& second, double rounding,
           const Eigen::Vector3d& first_to_second);

  /// Looks at all pairs along a unit direction.
  void raiseAlong(const Eigen::Vector3d& first_to_second);
  /// Looks at triangle i of the first leaf and all of the second, across the plane of i.
  void raiseAcrossFirst(std::uint32_t i);
  /// Looks at triangle j of the second leaf and all of the first, across the plane of j.
  void raiseAcrossSecond(std::uint32_t j);

  /// Pairs with at least this proven distance [m] are not open.
  void setFarEnough(double far_enough);
  bool isOpen(std::uint32_t i) const { return !(gaps_.col(i).minCoeff() >= enough_); }
  bool isOpen(std::uint32_t i, std::uint32_t j) const { return !(gaps_(j, i) >= enough_); }
  /// Takes the pair out, because the caller has its distance.
  void close(std::uint32_t i, std::uint32_t j);

  /// Proven lower bound of the distance of all pairs that are not closed [m].
  double lower() const;

 private:
  const PlacedLeaf& first_;
  const PlacedLeaf& second_;
  Eigen::Vector3f between_;  ///< from centre to centre
  double pad_;
  bool is_small_;
  float enough_ = 0;
  Eigen::Array<float, kTrianglesPerLeaf, kTrianglesPerLeaf> gaps_;  ///< largest so far, (j, i)
};

}  // namespace link_bounds
