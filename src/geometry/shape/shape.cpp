// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extents of points plus half-extents of the solid, moved by the translation and padded outward.
#include "link_bounds/geometry/shape/shape.h"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/shape/shape_steps.h"
#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr double kLargestLinearEntry = 1e30;

/// Tolerance with which vertices may be left out of an accelerated point set, relative to the
/// largest |coordinate|, and as much again for evaluating it.
constexpr double kPointTolerance = 2e-14;

/// Eight roundings bound every evaluation below: five of a dot product, one each for adding the
/// solid, the translation and the pad.
constexpr double kRoundingPad = 8 * kUnitRoundoff;

/// Products of tiny numbers lose digits below the smallest normal number.
constexpr double kUnderflowPad = std::numeric_limits<double>::min();

/// Half the extent of the solid along one axis of the world; `row` is that axis' row of the
/// linear part times diag(size). The support functions of the unit box, ball and cylinder.
double halfExtent(Solid solid, const Eigen::Vector3d& row) {
  switch (solid) {
    case Solid::kNone:
      return 0;
    case Solid::kBox:
      return ((std::abs(row.x()) + std::abs(row.y())) + std::abs(row.z())) / 2;
    case Solid::kEllipsoid:
      return length(row.x(), row.y(), row.z()) / 2;
    case Solid::kCylinder:
      return (length(row.x(), row.y()) + std::abs(row.z())) / 2;
  }
  return 0;
}

void addSolid(const Shape& shape, const Directions& linear, ShapeReach& reach) {
  for (int k = 0; k < 3; ++k) {
    const double half = halfExtent(shape.solid, linear.row(k).transpose().cwiseProduct(shape.size));
    reach.range.low[k] -= half;
    reach.range.high[k] += half;
  }
}

/// Bit k is set where row k differs; what is not a number differs from everything.
unsigned changedRows(const Directions& a, const Eigen::Matrix3d& b) {
  unsigned rows = 0;
  for (int k = 0; k < 3; ++k) {
    const bool is_same = a(k, 0) == b(k, 0) && a(k, 1) == b(k, 1) && a(k, 2) == b(k, 2);
    rows |= (is_same ? 0u : 1u) << k;
  }
  return rows;
}

bool isUsable(const Directions& linear) {
  return (linear.array().abs() <= kLargestLinearEntry).all();
}

/// By the given cells, or those found now.
void scanPoints(const PointSet& points, const Directions& linear, const CellsOfRows* cells,
                Extents& range) {
  if (cells) {
    scanCells(points.table(), linear, *cells, range);
  } else {
    range = points.extents(linear);
  }
}

/// False if an entry is too large or not a number. The sum tells that of all but the largest.
bool updateReach(const Shape& shape, const Directions& linear, const CellsOfRows* cells,
                 ShapeReach& reach) {
  if (shape.points) {
    scanPoints(*shape.points, linear, cells, reach.range);
  } else {
    reach.range = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  }
  if (shape.solid != Solid::kNone) addSolid(shape, linear, reach);
  reach.linear = linear;
  double magnitude = 0;
  for (int k = 0; k < 3; ++k) {
    const double entries =
        std::abs(reach.linear(k, 0)) + std::abs(reach.linear(k, 1)) + std::abs(reach.linear(k, 2));
    const double pad = entries * reach.pad_per_entry + kUnderflowPad;
    reach.range.low[k] -= pad;
    reach.range.high[k] += pad;
    magnitude += entries;
  }
  if (magnitude <= kLargestLinearEntry || isUsable(linear)) return true;
  reach.linear.setConstant(std::numeric_limits<double>::quiet_NaN());
  return false;
}

/// Only the rows whose bits are set; the query for another one is a repetition.
bool updateRows(const Shape& shape, const Directions& linear, unsigned rows, ShapeReach& reach) {
  Eigen::Matrix3d directions;
  for (int k = 0; k < 3; ++k)
    directions.row(k) = linear.row(rows & 1u << k ? k : __builtin_ctz(rows));
  ShapeReach fresh = reach;
  if (!updateReach(shape, directions, nullptr, fresh)) return false;
  for (int k = 0; k < 3; ++k) {
    if (!(rows & 1u << k)) continue;
    reach.linear.row(k) = fresh.linear.row(k);
    reach.range.low[k] = fresh.range.low[k];
    reach.range.high[k] = fresh.range.high[k];
  }
  return true;
}

bool update(const Shape& shape, const Directions& linear, const CellsOfRows* cells,
            ShapeReach& reach) {
  if (cells) return updateReach(shape, linear, cells, reach);
  const unsigned rows = changedRows(linear, reach.linear);
  if (rows == 0) return true;
  return rows == 7 ? updateReach(shape, linear, nullptr, reach)
                   : updateRows(shape, linear, rows, reach);
}

bool isFinite(const Aabb& box) {
  return std::isfinite((box.max() - box.min()).sum()) ||
         (box.min().allFinite() && box.max().allFinite());
}

}  // namespace

/// The largest cost of any column, which is nearly that of each.
ShapeReach::ShapeReach(const Shape& shape)
    : pad_per_entry(kRoundingPad * shape.size.maxCoeff() / 2),
      is_in_link_frame(shape.link_from_shape.matrix() == Eigen::Matrix4d::Identity()) {
  if (!shape.points) return;
  const double magnitude = shape.points->magnitude().maxCoeff();
  pad_per_entry += (kRoundingPad + kPointTolerance) * magnitude;
}

bool isUsablePose(const Eigen::Affine3d& pose) {
  return pose.translation().allFinite() && isUsable(pose.linear());
}

bool prefetchCells(const Shape& shape, const Eigen::Affine3d& world_from_shape,
                   const ShapeReach& reach, CellsOfRows& cells) {
  if (!shape.points || shape.points->isScanned()) return false;
  const auto linear = world_from_shape.linear();
  if (changedRows(linear, reach.linear) != 7) return false;
  findCells(shape.points->table(), linear, cells);
  return true;
}

/// The pad of the translation goes with it, the other one is in the reach.
bool placeBox(const Shape& shape, const Eigen::Affine3d& world_from_shape, const CellsOfRows* cells,
              ShapeReach& reach, Aabb& box) {
  if (!update(shape, world_from_shape.linear(), cells, reach)) return false;
  for (int k = 0; k < 3; ++k) {
    const double translation = world_from_shape(k, 3);
    const double pad = kRoundingPad * std::abs(translation);
    box.min()[k] = (translation - pad) + reach.range.low[k];
    box.max()[k] = (translation + pad) + reach.range.high[k];
  }
  return isFinite(box);
}

std::optional<Aabb> placedBox(const Shape& shape, const Eigen::Affine3d& world_from_shape,
                              ShapeReach& reach) {
  std::optional<Aabb> box(std::in_place);
  if (!placeBox(shape, world_from_shape, nullptr, reach, *box)) box.reset();
  return box;
}

std::optional<Aabb> worldBox(const Shape& shape, const Eigen::Affine3d& world_from_link) {
  ShapeReach reach(shape);
  return placedBox(shape, world_from_link * shape.link_from_shape, reach);
}

}  // namespace link_bounds
