// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Works in two dimensions: drops the axis along which the polygon is thinnest.
#include "robot/worker/polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {
namespace {

/// Max work for one polygon, a few seconds: the sum of its corners over all tries to cut an ear.
constexpr std::size_t kMaxLooks = 300'000'000;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct Corner {
  Eigen::Vector2d point;
  std::uint32_t vertex;
};

/// Above 0 if a, b and c turn to the left.
double turn(const Corner& a, const Corner& b, const Corner& c) {
  const Eigen::Vector2d in = b.point - a.point, out = c.point - b.point;
  return in.x() * out.y() - in.y() * out.x();
}

/// The corners in 2D, without the axis nearest to the normal; the polygon is then
/// counter-clockwise.
std::vector<Corner> flattened(const CornerIndices& corners,
                              const std::vector<Eigen::Vector3f>& vertices) {
  const auto at = [&](std::size_t i) -> Eigen::Vector3d {
    return vertices[corners[i % corners.size()]].cast<double>();
  };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (at(i) - at(0)).cross(at(i + 1) - at(0));
  int thinnest = 0;
  normal.cwiseAbs().maxCoeff(&thinnest);
  int x = (thinnest + 1) % 3, y = (thinnest + 2) % 3;
  if (normal[thinnest] < 0) std::swap(x, y);
  std::vector<Corner> result;
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.push_back({{at(i)[x], at(i)[y]}, corners[i]});
  return result;
}

/// The part of the polygon that is not yet cut off.
class Ring {
 public:
  explicit Ring(std::vector<Corner> corners) : corners_(std::move(corners)) {}

  std::size_t size() const { return corners_.size(); }
  bool isConvex() const {
    for (std::size_t i = 0; i < size(); ++i) {
      if (turnAt(i) < 0) return false;
    }
    return true;
  }

  /// The first corner that is at the place of the one before, or the tip of a spike; size() if
  /// there is none.
  std::size_t findFlat() const {
    std::size_t i = 0;
    while (i < size() && before(i).point != corners_[i].point && !goesBack(i))
      ++i;
    return i;
  }

  /// True if the triangle of this corner and its neighbours is inside the polygon, and the rest of
  /// the polygon does not run through it: no other corner that is concave or straight is in the
  /// triangle or on its edges, except at its corners, to which bridges to holes lead back.
  bool isEar(std::size_t i) const {
    return turnAt(i) >= 0 && !holds(i, [&](const Corner& corner, double turn, double least) {
             return turn <= 0 && least >= 0 && turnAt(i) > 0 && !isAtCorner(corner, i);
           });
  }

  /// As isEar(), for polygons that touch themselves: corners on an edge of the triangle do not
  /// count.
  bool isEarBesides(std::size_t i) const {
    return turnAt(i) >= 0 && !holds(i, [](const Corner&, double turn, double least) {
             return turn < 0 && least > 0;
           });
  }

  void cut(std::size_t i, Triangles& triangles) {
    triangles.push_back({before(i).vertex, corners_[i].vertex, after(i).vertex});
    corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void addFan(Triangles& triangles) const {
    for (std::size_t i = 2; i < size(); ++i)
      triangles.push_back({corners_[0].vertex, corners_[i - 1].vertex, corners_[i].vertex});
  }

 private:
  const Corner& before(std::size_t i) const { return corners_[(i + size() - 1) % size()]; }
  const Corner& after(std::size_t i) const { return corners_[(i + 1) % size()]; }
  double turnAt(std::size_t i) const { return turn(before(i), corners_[i], after(i)); }

  bool goesBack(std::size_t i) const {
    const Eigen::Vector2d in = corners_[i].point - before(i).point;
    return turnAt(i) == 0 && in.dot(after(i).point - corners_[i].point) < 0;
  }

  bool isAtCorner(const Corner& corner, std::size_t i) const {
    return corner.point == before(i).point || corner.point == corners_[i].point ||
           corner.point == after(i).point;
  }

  /// True if `counts` is true for a corner. It gets the corner, its turn, and the min turn from an
  /// edge of the triangle at i to it, which is above 0 inside.
  template <class Counts>
  bool holds(std::size_t i, const Counts& counts) const {
    for (std::size_t k = 0; k < size(); ++k) {
      const Corner& corner = corners_[k];
      const double least =
          std::min({turn(before(i), corners_[i], corner), turn(corners_[i], after(i), corner),
                    turn(after(i), before(i), corner)});
      if (counts(corner, turnAt(k), least)) return true;
    }
    return false;
  }

  std::vector<Corner> corners_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> trianglesOf(
    const CornerIndices& corners, const std::vector<Eigen::Vector3f>& vertices) {
  Triangles triangles;
  if (corners.size() < 3) return triangles;
  Ring ring(flattened(corners, vertices));
  std::size_t i = 0, tried = 0, looks = 0;
  while (ring.size() > 3 && tried < 2 * ring.size()) {
    looks += ring.size();
    if (looks > kMaxLooks)
      throw MeshError("a polygon with so many corners has too many notches; store triangles");
    const std::size_t flat = tried == 0 ? ring.findFlat() : ring.size();
    const bool is_flat = flat < ring.size();
    if (tried == 0 && !is_flat && ring.isConvex()) break;
    i = is_flat ? flat : i % ring.size();
    if (is_flat || (tried < ring.size() ? ring.isEar(i) : ring.isEarBesides(i))) {
      ring.cut(i, triangles);
      tried = 0;
    } else {
      ++i;
      ++tried;
    }
  }
  ring.addFan(triangles);
  return triangles;
}

}  // namespace link_bounds
