// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a point is inside a mesh.
//
// Triangles that share an edge belong to one part; vertices of equal coordinates are one. A part is
// closed if an even number of its triangles meets at each edge. Then any ray from a point that
// passes through no edge crosses the part an even or an odd number of times, whatever its
// direction: odd is inside. A part that is not closed has no inside. Two solids that share an edge
// are one part: if all its triangles have the same side outside, what the part winds around is
// inside, too, so also what both have in common.
//
// A triangle may be there twice: as the wall between two boxes, of which no ray needs to know, or
// because an exporter wrote each face for both of its sides. So triangles of which there is an even
// number are left out; if nothing closed is left then, each counts once.
#pragma once

#include <optional>
#include <vector>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

class MeshInside {
 public:
  /// The tree must live as long, and no solid may sweep its triangles.
  explicit MeshInside(const TriangleTree& tree);

  bool hasInside() const { return has_inside_; }

  /// True if the point is inside a closed part: so a cavity that a closed shell surrounds is
  /// inside. A ray that passes too close to an edge to be sure is replaced by another one; nothing
  /// if all are.
  std::optional<bool> contains(const Eigen::Vector3d& point) const;

  /// True if the segment surely goes through a triangle, also one of an open part: not through its
  /// edge, and neither end is on it.
  bool crosses(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  enum class Crossing { kNo, kLeft, kRight, kUnsure };  ///< from which side of the triangle

  /// A triangle that a ray crosses.
  struct Crossed {
    std::uint32_t part;
    int side;  ///< 1 or -1
  };

  /// Appends the triangles of closed parts that the ray crosses; false if one of them is unsure.
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
  std::vector<std::uint32_t> parts_;  ///< by triangle; kOpen: of no closed part, or left out
  std::vector<bool> is_oriented_;     ///< by part: its triangles agree on what is inside
  bool has_inside_ = false;
};

}  // namespace link_bounds
