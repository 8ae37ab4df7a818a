// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a point is inside a mesh.
//
// Triangles that share an edge belong to one part; vertices of equal coordinates are one. A part is
// closed if an even number of its triangles meets at each edge. Then the number of times that a ray
// from a point crosses the part is odd if the point is inside, else even, whatever the direction,
// as long as the ray passes through no edge. A part that is not closed has no inside. Two solids
// that share an edge are one part. If the triangles of a part are oriented consistently, a point
// with a winding number other than 0 is inside, too, so that the overlap of the two solids is
// inside.
//
// A triangle may occur twice: as the wall between two boxes, which no ray needs to count, or
// because an exporter wrote each face once per side. So the counts of a part are halved while all
// are even, and triangles whose count is even then are left out. If the others of the part do not
// form a closed surface, each triangle counts once instead.
#pragma once

#include <optional>
#include <vector>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

class MeshInside {
 public:
  /// `tree` must outlive this object, and no solid may sweep its triangles.
  explicit MeshInside(const TriangleTree& tree);

  bool hasInside() const { return has_inside_; }

  /// True if the point is inside a closed part. A cavity that a closed shell surrounds is inside. A
  /// ray that passes too close to an edge to be sure is replaced by another one; nothing if all
  /// rays do.
  std::optional<bool> contains(const Eigen::Vector3d& point) const;

  /// True if the segment surely goes through the interior of a triangle, also of an open part. A
  /// segment through an edge, or with an end on the triangle, does not count.
  bool crosses(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  enum class Crossing { kNo, kLeft, kRight, kUnsure };  ///< from which side of the triangle

  /// A triangle that a ray crosses.
  struct Crossed {
    std::uint32_t part;
    int side;  ///< 1 or -1
  };

  /// Appends the triangles of closed parts that the ray crosses; false if one crossing is unsure.
  bool cast(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
            std::vector<Crossed>& crossed) const;
  template <class Visit>
  bool visitAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                  const Visit& visit) const;
  static bool isCrossed(Crossing crossing) {
    return crossing == Crossing::kLeft || crossing == Crossing::kRight;
  }
  Crossing cross(std::size_t triangle, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& direction) const;

  const TriangleTree& tree_;
  std::vector<std::uint32_t> parts_;  ///< by triangle; kOpen: in no closed part, or left out
  std::vector<bool> is_oriented_;     ///< by part: its triangles are oriented consistently
  bool has_inside_ = false;
};

}  // namespace link_bounds
