// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A simplex of up to four points of the difference of two convex sets, and its point nearest to the
// origin: the distance subalgorithm of GJK.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>

namespace link_bounds {

/// A point of the difference of two sets, and the two points that it is the difference of, each in
/// the coordinates of its shape.
struct DifferencePoint {
  Eigen::Vector3d difference;  ///< first - second, in the axes of the world
  Eigen::Vector3d first;
  Eigen::Vector3d second;
};

/// The combination of the points of a simplex with these weights, whose sum is 1.
struct SimplexPoint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::array<double, 4> weights{};
};

class Simplex {
 public:
  Simplex() = default;
  Simplex(const Simplex& other) { *this = other; }
  /// Copies no more points than there are.
  Simplex& operator=(const Simplex& other);

  std::size_t size() const { return size_; }
  const DifferencePoint& operator[](std::size_t i) const { return points_[i]; }
  bool contains(const Eigen::Vector3d& difference) const;

  /// There must be fewer than four points.
  void add(const DifferencePoint& point) {
    assert(size_ < points_.size());
    points_[size_++] = point;
  }

  /// Takes back add().
  void removeLast() { --size_; }

  /// The point nearest to the origin. Every candidate is a convex combination of the points, so
  /// rounding can give a point that is slightly farther away, but none outside the difference of
  /// the sets.
  SimplexPoint nearest() const { return nearest(0); }

  /// As nearest(), but faster: tries only edges and faces that have the last added point as a
  /// corner.
  SimplexPoint nearestWithLast() const { return nearest(1u << (size_ - 1)); }

  /// Keeps the points of which `nearest` is a combination.
  void keep(const SimplexPoint& nearest);

  /// `normal`, the direction of the nearest point at distance `length`, made perpendicular to all
  /// edges that are much longer than that. Rounding leaves so near a point few digits, so these
  /// edges determine its direction better.
  Eigen::Vector3d acrossEdges(const Eigen::Vector3d& normal, double length) const;

  /// The points of the two sets whose difference is the point of the last keep().
  Eigen::Vector3d first() const { return combined(&DifferencePoint::first); }
  Eigen::Vector3d second() const { return combined(&DifferencePoint::second); }

 private:
  Eigen::Vector3d combined(Eigen::Vector3d DifferencePoint::*point) const;
  SimplexPoint nearest(unsigned required) const;

  std::array<DifferencePoint, 4> points_;
  std::array<double, 4> weights_{};  ///< of the point of the last keep()
  std::size_t size_ = 0;
};

}  // namespace link_bounds
