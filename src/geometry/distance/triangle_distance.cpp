// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Tries all 15 pairs of features: each corner with the other triangle (6) and each edge with each
// edge (9), and last whether an edge pierces a triangle. Ends early only where the supports of the
// triangles prove that two points are nearest. The result of one pair of features never rules out
// another; the routine of PQP and FCL does that and goes wrong.
#include "geometry/distance/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace link_bounds {
namespace {

/// Squared sine of the angle below which a triangle counts as thin.
constexpr double kThin = 1e-6;

/// Two points count as nearest if the gap of the triangles is at least this fraction of the points'
/// distance.
constexpr double kProven = 1 - 1e-13;

class NearestOfTriangles {
 public:
  NearestOfTriangles(const Triangle& first, const Triangle& second, double enough)
      : first_(first), second_(second), enough_(enough) {}

  PointPair pair{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                 std::numeric_limits<double>::infinity()};

  void offer(const Eigen::Vector3d& on_first, const Eigen::Vector3d& on_second, bool swapped) {
    const double squared = (on_second - on_first).squaredNorm();
    if (!(squared < pair.squared)) return;
    pair =
        swapped ? PointPair{on_second, on_first, squared} : PointPair{on_first, on_second, squared};
    is_new_ = true;
  }

  bool isDone() {
    if (!is_new_) return false;
    is_new_ = false;
    const double gap = gapAlong(pair.on_second - pair.on_first, first_, second_);
    return gap > 0 && (gap >= kProven * pair.squared || gap >= enough_ * std::sqrt(pair.squared));
  }

 private:
  const Triangle& first_;
  const Triangle& second_;
  double enough_;
  bool is_new_ = false;  ///< `pair` has changed since the last isDone()
};

/// The point of the segment from a along `edge` that is nearest to `point`.
Eigen::Vector3d nearestOnEdge(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                              const Eigen::Vector3d& edge, double squared_edge) {
  const double along = (point - a).dot(edge);
  if (!(along > 0)) return a;
  return a + std::min(along / squared_edge, 1.0) * edge;
}

/// A triangle and what several feature pairs use of it.
struct Features {
  explicit Features(const Triangle& triangle)
      : corners(triangle),
        edges{{triangle[1] - triangle[0], triangle[2] - triangle[1], triangle[0] - triangle[2]}},
        squared_edges{edges[0].squaredNorm(), edges[1].squaredNorm(), edges[2].squaredNorm()},
        ab(edges[0].dot(edges[2])),
        determinant(squared_edges[0] * squared_edges[2] - ab * ab) {}

  /// True if rounding may decide which points are inside, so that the edges must be tried, too.
  bool isThin() const { return !(determinant > kThin * squared_edges[0] * squared_edges[2]); }

  /// Projects `point` on the plane; false if the projection is not inside the triangle.
  bool project(const Eigen::Vector3d& point, Eigen::Vector3d& projection) const {
    double s = 0, t = 0;
    addProjected(point - corners[0], s, t);
    if (!isInside(s, t)) return false;
    projection = placed(s, t);
    if (!isThin()) return true;
    // A small determinant has few digits, so the offset from the projection is projected once more.
    addProjected(point - projection, s, t);
    if (isInside(s, t)) projection = placed(s, t);
    return true;
  }

  /// The plane is spanned by edges[0] and -edges[2] from corner 0.
  void addProjected(const Eigen::Vector3d& from, double& s, double& t) const {
    const double pa = from.dot(edges[0]), pb = -from.dot(edges[2]);
    s += squared_edges[2] * pa + ab * pb;
    t += squared_edges[0] * pb + ab * pa;
  }

  /// `s` and `t` are coordinates along the edges, times the determinant.
  bool isInside(double s, double t) const { return s > 0 && t > 0 && s + t < determinant; }
  Eigen::Vector3d placed(double s, double t) const {
    return corners[0] + (s / determinant) * edges[0] - (t / determinant) * edges[2];
  }

  Triangle corners;
  std::array<Eigen::Vector3d, 3> edges;  ///< from corner i to the next
  std::array<double, 3> squared_edges;
  double ab;  ///< edges[0] . edges[2]
  double determinant;
};

void tryCorner(const Eigen::Vector3d& corner, const Features& other, bool swapped,
               NearestOfTriangles& nearest) {
  Eigen::Vector3d projection;
  if (other.project(corner, projection)) {
    nearest.offer(corner, projection, swapped);
    if (!other.isThin()) return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    nearest.offer(corner,
                  nearestOnEdge(corner, other.corners[i], other.edges[i], other.squared_edges[i]),
                  swapped);
  }
}

/// Offers the nearest points of two lines if both are inside their edges. tryCorner() covers the
/// ends.
void tryEdges(const Features& first, std::size_t i, const Features& second, std::size_t j,
              NearestOfTriangles& nearest) {
  const Eigen::Vector3d& d = first.edges[i];
  const Eigen::Vector3d& e = second.edges[j];
  const Eigen::Vector3d between = first.corners[i] - second.corners[j];
  const double dd = first.squared_edges[i], ee = second.squared_edges[j];
  const double de = d.dot(e), db = d.dot(between), eb = e.dot(between);
  const double determinant = dd * ee - de * de;
  const double s = de * eb - ee * db;
  const double t = dd * eb - de * db;
  if (!(s > 0 && s < determinant && t > 0 && t < determinant)) return;
  nearest.offer(first.corners[i] + (s / determinant) * d, second.corners[j] + (t / determinant) * e,
                false);
}

/// A common point, where an edge crosses the plane of the other triangle inside that triangle.
void tryPiercing(const Features& edges, const Features& other, bool swapped,
                 NearestOfTriangles& nearest) {
  const Eigen::Vector3d normal = other.edges[0].cross(other.edges[1]);
  double height[3];
  for (std::size_t i = 0; i < 3; ++i)
    height[i] = normal.dot(edges.corners[i] - other.corners[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double begin = height[i], end = height[(i + 1) % 3];
    if (!((begin < 0 && end > 0) || (begin > 0 && end < 0))) continue;
    const Eigen::Vector3d point = edges.corners[i] + begin / (begin - end) * edges.edges[i];
    Eigen::Vector3d projection;
    if (other.project(point, projection)) nearest.offer(point, projection, swapped);
  }
}

}  // namespace

double gapAlong(const Eigen::Vector3d& normal, const Triangle& first, const Triangle& second) {
  const double first_max =
      std::max({normal.dot(first[0]), normal.dot(first[1]), normal.dot(first[2])});
  const double second_min =
      std::min({normal.dot(second[0]), normal.dot(second[1]), normal.dot(second[2])});
  return second_min - first_max;
}

PointPair nearestPoints(const Triangle& first, const Triangle& second, double enough) {
  const Features a(first), b(second);
  NearestOfTriangles nearest(first, second, enough);
  for (std::size_t i = 0; i < 3; ++i) {
    tryCorner(a.corners[i], b, false, nearest);
    if (nearest.isDone()) return nearest.pair;
    tryCorner(b.corners[i], a, true, nearest);
    if (nearest.isDone()) return nearest.pair;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      tryEdges(a, i, b, j, nearest);
      if (nearest.isDone()) return nearest.pair;
    }
  }
  tryPiercing(a, b, false, nearest);
  tryPiercing(b, a, true, nearest);
  return nearest.pair;
}

}  // namespace link_bounds
