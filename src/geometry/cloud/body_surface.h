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

/// [m]
struct PointDistance {
  double lower;  ///< proven: no point of the body is nearer
  double upper;  ///< proven: a point of the body is at most so far away
};

/// A body in its own frame. Meshes are surfaces; solids, and meshes without triangles as their
/// convex hulls, are filled. Immutable, so any number of threads may use it.
class BodySurface {
 public:
  /// What `check_interrupt` throws ends it.
  explicit BodySurface(const Body& body, const CheckInterrupt& check_interrupt = nullptr);

  /// The bounds differ by less than 1e-6 m for solids and by rounding for triangles. Distances
  /// beyond `limit` need not be known: `lower` is then at least `limit`, and `upper` may be
  /// infinite. Once `upper` is at most `near`, the search ends, and `lower` may be 0.
  PointDistance distance(const Eigen::Vector3d& point,
                         double limit = std::numeric_limits<double>::infinity(),
                         double near = -1) const;

  /// True for a point inside a closed part of a mesh; see MeshInside. Solids are not looked at:
  /// inside them the distance is 0.
  bool contains(const Eigen::Vector3d& point) const;

  /// Whether contains() can be true.
  bool hasInside() const;

  /// Around all shapes.
  const Aabb& box() const { return box_; }

  /// Bytes of the trees.
  std::size_t bytes() const;

 private:
  struct Mesh {
    std::shared_ptr<const TriangleTree> tree;  ///< in the frame of the body
    MeshInside inside;
  };

  void addMesh(const BodyShape& shape, const CheckInterrupt& check_interrupt);

  Body solids_;  ///< all that has no triangles, or triangles that a solid sweeps
  std::vector<Mesh> meshes_;
  Aabb box_;
};

}  // namespace link_bounds
