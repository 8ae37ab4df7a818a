// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Projects the origin onto each face, and where no face is proven to be nearest, onto each edge and
// vertex, and takes the nearest projection that lies inside. Slower than a search that looks at
// signs first, but a degenerate simplex does no harm: a face without area has no projection, and
// its edges remain. Of faces, edges and vertices that are equally near, the one with more corners
// counts: it says more about the normal.
#include "geometry/distance/simplex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace link_bounds {
namespace {

using Vectors = std::array<Eigen::Vector3d, 4>;

/// Max difference of coordinates of magnitude 1 that is due to rounding alone.
constexpr double kNoise = 4e-16;

/// Square of a ratio: at 1e-4 of an edge's length, digits of the nearest point have begun to
/// cancel.
constexpr double kClose = 1e-8;

/// The nearest point so far: a combination of the points whose bits are set.
class NearestToOrigin {
 public:
  explicit NearestToOrigin(double magnitude) : noise_(kNoise * magnitude) {}

  SimplexPoint found;

  /// Takes the candidate if it is nearer by more than rounding: of points that are equally near,
  /// the first one stays.
  void offer(const Eigen::Vector3d& candidate, const std::array<double, 4>& candidate_weights) {
    const double squared = candidate.squaredNorm();
    if (!(squared < limit_)) return;
    const double noise = noise_ * std::sqrt(squared);
    limit_ = squared - noise;
    least_ = squared - 8 * noise;
    found = {candidate, candidate_weights};
  }

  /// Whether no point of the simplex is nearer than `found` by more than rounding: all are beyond
  /// the plane through `found` that is normal to it.
  bool isProven(const Vectors& points, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (!(points[i].dot(found.point) >= least_)) return false;
    }
    return true;
  }

 private:
  double noise_;
  double limit_ = std::numeric_limits<double>::infinity();  ///< of the squared distance of the next
                                                            ///< candidate
  double least_ = std::numeric_limits<double>::infinity();  ///< the squared distance that
                                                            ///< isProven() demands
};

constexpr unsigned bit(std::size_t i) {
  return 1u << i;
}

void tryVertex(const Vectors& p, std::size_t i, NearestToOrigin& nearest) {
  std::array<double, 4> weights{};
  weights[i] = 1;
  nearest.offer(p[i], weights);
}

void tryEdge(const Vectors& p, std::size_t i, std::size_t j, NearestToOrigin& nearest) {
  const Eigen::Vector3d edge = p[j] - p[i];
  const double along = -p[i].dot(edge);
  const double squared = edge.squaredNorm();
  if (!(along > 0 && along < squared)) return;
  const double t = along / squared;
  std::array<double, 4> weights{};
  weights[i] = 1 - t;
  weights[j] = t;
  nearest.offer(p[i] + t * edge, weights);
}

/// A second pass begins at the projection, where few digits cancel.
void tryFace(const Vectors& p, std::size_t i, std::size_t j, std::size_t k,
             NearestToOrigin& nearest) {
  const Eigen::Vector3d a = p[j] - p[i];
  const Eigen::Vector3d b = p[k] - p[i];
  const double aa = a.squaredNorm();
  const double ab = a.dot(b) / aa;
  const Eigen::Vector3d across = b - ab * a;
  const double squared = across.squaredNorm();
  double s = 0, t = 0;
  Eigen::Vector3d point = p[i];
  for (int pass = 0; pass < 2; ++pass) {
    const double dt = -point.dot(across) / squared;
    t += dt;
    if (!(t > 0)) return;
    const double ds = -point.dot(a) / aa - ab * dt;
    s += ds;
    if (!(s > 0 && s + t < 1)) return;
    point += ds * a + dt * b;
    if (!(point.squaredNorm() < kClose * aa)) break;
  }
  std::array<double, 4> weights{};
  weights[i] = 1 - s - t;
  weights[j] = s;
  weights[k] = t;
  nearest.offer(point, weights);
}

/// The origin is inside if its four barycentric coordinates, each a volume, are not negative.
/// Rounding may give any coordinates to a flat tetrahedron, so the point that they stand for
/// counts.
void tryInside(const Vectors& p, NearestToOrigin& nearest) {
  const Eigen::Vector3d a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double volume = a.dot(b.cross(c));
  const double w1 = -p[0].dot(b.cross(c)) / volume;
  const double w2 = -p[0].dot(c.cross(a)) / volume;
  const double w3 = -p[0].dot(a.cross(b)) / volume;
  const double w0 = 1 - w1 - w2 - w3;
  if (!(w0 >= 0 && w1 >= 0 && w2 >= 0 && w3 >= 0)) return;
  nearest.offer(p[0] + w1 * a + w2 * b + w3 * c, {w0, w1, w2, w3});
}

}  // namespace

Simplex& Simplex::operator=(const Simplex& other) {
  size_ = other.size_;
  std::copy_n(other.points_.begin(), size_, points_.begin());
  weights_ = other.weights_;
  return *this;
}

bool Simplex::contains(const Eigen::Vector3d& difference) const {
  for (std::size_t i = 0; i < size_; ++i) {
    if (points_[i].difference == difference) return true;
  }
  return false;
}

SimplexPoint Simplex::nearest(unsigned required) const {
  if (size_ == 1) return {points_[0].difference, {1}};
  Vectors p;
  for (std::size_t i = 0; i < size_; ++i)
    p[i] = points_[i].difference;
  NearestToOrigin nearest(p[size_ - 1].cwiseAbs().maxCoeff());
  const auto isWanted = [required](unsigned bits) { return (bits & required) == required; };
  if (size_ == 4) tryInside(p, nearest);
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        if (isWanted(bit(i) | bit(j) | bit(k))) tryFace(p, i, j, k, nearest);
      }
    }
  }
  if (nearest.isProven(p, size_)) return nearest.found;
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (isWanted(bit(i) | bit(j))) tryEdge(p, i, j, nearest);
    }
  }
  for (std::size_t i = 0; i < size_; ++i) {
    if (isWanted(bit(i))) tryVertex(p, i, nearest);
  }
  return nearest.found;
}

void Simplex::keep(const SimplexPoint& nearest) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (nearest.weights[i] == 0) continue;
    if (kept != i) points_[kept] = points_[i];
    weights_[kept++] = nearest.weights[i];
  }
  size_ = kept;
}

Eigen::Vector3d Simplex::acrossEdges(const Eigen::Vector3d& normal, double length) const {
  if (size_ < 2 || size_ > 3) return normal;
  Eigen::Vector3d a = points_[1].difference - points_[0].difference;
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  if (size_ == 3) {
    b = points_[2].difference - points_[0].difference;
    if (b.squaredNorm() > a.squaredNorm()) a.swap(b);
  }
  const double aa = a.squaredNorm();
  if (!(kClose * aa > length * length)) return normal;
  b -= (b.dot(a) / aa) * a;
  const double bb = b.squaredNorm();
  Eigen::Vector3d result = normal;
  for (int pass = 0; pass < 2; ++pass) {
    result -= (result.dot(a) / aa) * a;
    if (kClose * bb > length * length) result -= (result.dot(b) / bb) * b;
    result.normalize();
  }
  return result;
}

Eigen::Vector3d Simplex::combined(Eigen::Vector3d DifferencePoint::*point) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < size_; ++i)
    sum += weights_[i] * points_[i].*point;
  return sum;
}

}  // namespace link_bounds
