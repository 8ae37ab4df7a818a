// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Projects the origin onto each vertex, edge and face, and takes the nearest projection that lies
// inside. Slower than a search that looks at signs first, but a degenerate simplex does no harm: a
// face without area has no projection, and its edges remain.
#include "geometry/distance/simplex.h"

#include <Eigen/Geometry>
#include <limits>

namespace link_bounds {
namespace {

using Vectors = std::array<Eigen::Vector3d, 4>;

/// The nearest point so far: a combination of the points whose bits are set.
struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::array<double, 4> weights{};

  void offer(const Eigen::Vector3d& candidate, const std::array<double, 4>& candidate_weights) {
    const double candidate_squared = candidate.squaredNorm();
    if (!(candidate_squared < squared)) return;
    squared = candidate_squared;
    point = candidate;
    weights = candidate_weights;
  }
};

constexpr unsigned bit(std::size_t i) {
  return 1u << i;
}

void tryVertex(const Vectors& p, std::size_t i, Nearest& nearest) {
  std::array<double, 4> weights{};
  weights[i] = 1;
  nearest.offer(p[i], weights);
}

void tryEdge(const Vectors& p, std::size_t i, std::size_t j, Nearest& nearest) {
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

void tryFace(const Vectors& p, std::size_t i, std::size_t j, std::size_t k, Nearest& nearest) {
  const Eigen::Vector3d a = p[j] - p[i];
  const Eigen::Vector3d b = p[k] - p[i];
  const double aa = a.squaredNorm(), ab = a.dot(b), bb = b.squaredNorm();
  const double pa = -p[i].dot(a), pb = -p[i].dot(b);
  const double det = aa * bb - ab * ab;
  const double s = bb * pa - ab * pb;
  const double t = aa * pb - ab * pa;
  if (!(s > 0 && t > 0 && s + t < det)) return;
  std::array<double, 4> weights{};
  weights[i] = 1 - s / det - t / det;
  weights[j] = s / det;
  weights[k] = t / det;
  nearest.offer(p[i] + (s / det) * a + (t / det) * b, weights);
}

/// The origin is inside if its four barycentric coordinates, each a volume, are not negative.
void tryInside(const Vectors& p, Nearest& nearest) {
  const Eigen::Vector3d a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double volume = a.dot(b.cross(c));
  const double w1 = -p[0].dot(b.cross(c)) / volume;
  const double w2 = -p[0].dot(c.cross(a)) / volume;
  const double w3 = -p[0].dot(a.cross(b)) / volume;
  const double w0 = 1 - w1 - w2 - w3;
  if (!(w0 >= 0 && w1 >= 0 && w2 >= 0 && w3 >= 0)) return;
  nearest.squared = 0;
  nearest.point.setZero();
  nearest.weights = {w0, w1, w2, w3};
}

}  // namespace

bool Simplex::contains(const Eigen::Vector3d& difference) const {
  for (std::size_t i = 0; i < size_; ++i) {
    if (points_[i].difference == difference) return true;
  }
  return false;
}

Eigen::Vector3d Simplex::reduceTo(unsigned required) {
  Vectors p;
  for (std::size_t i = 0; i < size_; ++i)
    p[i] = points_[i].difference;
  Nearest nearest;
  const auto isWanted = [required](unsigned bits) { return (bits & required) == required; };
  for (std::size_t i = 0; i < size_; ++i) {
    if (isWanted(bit(i))) tryVertex(p, i, nearest);
    for (std::size_t j = 0; j < i; ++j) {
      if (isWanted(bit(i) | bit(j))) tryEdge(p, i, j, nearest);
      for (std::size_t k = 0; k < j; ++k) {
        if (isWanted(bit(i) | bit(j) | bit(k))) tryFace(p, i, j, k, nearest);
      }
    }
  }
  if (size_ == 4) tryInside(p, nearest);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (nearest.weights[i] == 0) continue;
    points_[kept] = points_[i];
    weights_[kept++] = nearest.weights[i];
  }
  size_ = kept;
  return nearest.point;
}

Eigen::Vector3d Simplex::first() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < size_; ++i)
    sum += weights_[i] * points_[i].first;
  return sum;
}

Eigen::Vector3d Simplex::second() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < size_; ++i)
    sum += weights_[i] * points_[i].second;
  return sum;
}

}  // namespace link_bounds
