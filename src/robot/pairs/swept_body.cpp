// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles are cut into slabs across the axis. In a slab the farthest point from the axis is an
// end of a part of an edge, because the distance from a line is convex.
#include "robot/pairs/swept_body.h"

#include <algorithm>
#include <vector>

#include "geometry/distance/triangle_tree.h"
#include "robot/pairs/body_cloud.h"
#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

/// More fit better, and take longer to compare. Neighbours become one cylinder where that adds no
/// more to a radius than this share.
constexpr std::size_t kSlabs = 64;
constexpr double kAdded = 0.03;

/// Along the axis from `low` to `high` no point is farther from it than the radius.
struct Slab {
  double low;
  double high;
  double radius = -1;  ///< negative: there is no point
};

/// Those of which the radius hardly differs are one.
std::vector<Slab> merged(const std::vector<Slab>& slabs) {
  std::vector<Slab> result;
  double smallest = 0;
  for (const Slab& slab : slabs) {
    if (!result.empty()) {
      Slab& last = result.back();
      const double low = std::min(smallest, slab.radius);
      const double high = std::max(last.radius, slab.radius);
      if ((low >= 0 && high - low <= kAdded * high) || high < 0) {
        last = {last.low, slab.high, high};
        smallest = low;
        continue;
      }
    }
    result.push_back(slab);
    smallest = slab.radius;
  }
  return result;
}

class Sweep {
 public:
  Sweep(const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis) : pose_(pose), axis_(axis) {
    // Quaterniond::FromTwoVectors is no rotation where the axis is nearly that of -z.
    const Eigen::Vector3d x = axis.unitOrthogonal();
    turned_.linear() << x, axis.cross(x), axis;
  }

  void add(const BodyShape& shape) {
    const Axis axis{pose_.inverse() * Eigen::Vector3d::Zero(), pose_.linear().transpose() * axis_};
    const BodyCloud cloud({{shape}});
    const double at = axis.direction.dot(axis.origin);
    rounding_ = kPoseRounding * (cloud.magnitude() + axis.origin.norm());
    Slab all{-cloud.support(-axis.direction) - at, cloud.support(axis.direction) - at,
             cloud.farthestFrom(axis)};
    if (!shape.triangles || shape.triangles->solid != Solid::kNone || !(all.low < all.high))
      return addCylinder(all);
    for (const Slab& slab : merged(slabsOf(shape, all)))
      if (slab.radius >= 0) addCylinder(slab);
  }

  Body result() const { return body_; }

 private:
  std::vector<Slab> slabsOf(const BodyShape& shape, const Slab& all) const {
    std::vector<Slab> slabs;
    const double height = (all.high - all.low) / kSlabs;
    for (std::size_t i = 0; i < kSlabs; ++i)
      slabs.push_back({all.low + height * static_cast<double>(i),
                       all.low + height * static_cast<double>(i + 1)});
    const TriangleTree& tree = *shape.triangles;
    std::vector<Eigen::Vector3d> vertices;
    for (const Eigen::Vector3d& vertex : tree.vertices)
      vertices.push_back(turned_.inverse() * (pose_ * (shape.shape.link_from_shape * vertex)));
    for (const auto& [a, b, c] : tree.triangles) {
      addEdge(vertices[a], vertices[b], slabs);
      addEdge(vertices[b], vertices[c], slabs);
      addEdge(vertices[c], vertices[a], slabs);
    }
    return slabs;
  }

  /// To all slabs that it meets, and to one that it misses by rounding.
  void addEdge(Eigen::Vector3d a, Eigen::Vector3d b, std::vector<Slab>& slabs) const {
    if (a.z() > b.z()) std::swap(a, b);
    for (Slab& slab : slabs) {
      if (slab.high < a.z() - rounding_ || slab.low > b.z() + rounding_) continue;
      for (const double end : {slab.low, slab.high}) {
        const double share = b.z() > a.z() ? (end - a.z()) / (b.z() - a.z()) : 0;
        const Eigen::Vector3d at = a + std::min(std::max(share, 0.0), 1.0) * (b - a);
        slab.radius = std::max(slab.radius, at.head<2>().norm());
      }
      if (b.z() == a.z()) slab.radius = std::max(slab.radius, b.head<2>().norm());
    }
  }

  void addCylinder(const Slab& slab) {
    const double diameter = 2 * (slab.radius + 2 * rounding_);
    Shape& cylinder = body_.shapes.emplace_back().shape;
    cylinder.solid = Solid::kCylinder;
    cylinder.size = {diameter, diameter, slab.high - slab.low + 4 * rounding_};
    cylinder.link_from_shape = turned_ * Eigen::Translation3d(0, 0, (slab.low + slab.high) / 2);
  }

  Eigen::Isometry3d pose_;
  Eigen::Vector3d axis_;
  Eigen::Isometry3d turned_ = Eigen::Isometry3d::Identity();  ///< z along the axis
  double rounding_ = 0;
  Body body_;
};

}  // namespace

Body sweptBody(const Body& body, const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis) {
  Sweep sweep(pose, axis);
  for (const BodyShape& shape : body.shapes)
    sweep.add(shape);
  return sweep.result();
}

}  // namespace link_bounds
