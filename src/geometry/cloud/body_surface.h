// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a point is from a body, between two proven bounds, and whether it is inside.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "geometry/cloud/mesh_inside.h"
#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// Two bounds of the distance of a point from a body [m].
struct PointDistance {
  double lower;  ///< proven: no point of the body is nearer
  double upper;  ///< proven: a point of the body is at most so far away
};

/// The point of a body that is the nearest one to another point.
struct SurfacePoint {
  PointDistance distance;  ///< `upper` is the distance of `on_body`
  Eigen::Vector3d on_body;
  bool is_of_mesh;  ///< `on_body` is on a triangle, not on a solid or a convex hull
};

/// A body in its own frame. Meshes are surfaces; solids, and meshes without triangles as their
/// convex hulls, are filled. Immutable, so any number of threads may use it.
class BodySurface {
 public:
  /// For each mesh, the triangle that was nearest to the last point.
  using Hint = std::vector<std::uint32_t>;

  /// An exception of `check_interrupt` is passed on.
  explicit BodySurface(const Body& body, const CheckInterrupt& check_interrupt = nullptr);

  /// The bounds differ by less than 1e-6 m for solids and by rounding for triangles. Distances
  /// beyond `limit` need not be known: `lower` is then at least `limit`, and `upper` may be
  /// infinite. Once `upper` is at most `near`, the search ends, and `lower` may be 0. A `hint` from
  /// a call for a nearby point makes the search faster.
  PointDistance distance(const Eigen::Vector3d& point,
                         double limit = std::numeric_limits<double>::infinity(), double near = -1,
                         Hint* hint = nullptr) const;

  /// The nearest point of the body, which must have a shape.
  SurfacePoint nearest(const Eigen::Vector3d& point) const;

  /// True if the segment surely goes through the inside of a triangle, or comes within a micrometre
  /// of a solid. Convex hulls of meshes without triangles prove nothing. A solid may be missed if
  /// less than half a millimetre of the segment is inside it.
  bool crosses(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// True for a point inside a closed part of a mesh; see MeshInside. Nothing if that is not sure.
  /// Solids are not looked at: inside them the distance is 0.
  std::optional<bool> contains(const Eigen::Vector3d& point) const;

  /// Whether contains() can be true.
  bool hasInside() const;

  /// The box of all shapes, in the frame of the body.
  const Aabb& box() const { return box_; }

  /// False if a shape is left out, because its coordinates are too large or not finite.
  bool isWhole() const { return is_whole_; }

  /// Bytes of the trees.
  std::size_t bytes() const;

 private:
  struct Mesh {
    std::shared_ptr<const TriangleTree> tree;  ///< in the frame of the body; maybe shared
    MeshInside inside;
  };

  void addMesh(const BodyShape& shape, const CheckInterrupt& check_interrupt);
  bool crossesSolid(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  Body solids_;  ///< shapes without triangles, or with triangles that a solid sweeps
  std::vector<Mesh> meshes_;
  Aabb box_;
  bool is_whole_ = true;
};

}  // namespace link_bounds
