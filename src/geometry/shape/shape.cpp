// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Extents of points plus half-extents of the solid, moved by the translation and padded outward.
#include "link_bounds/geometry/shape/shape.h"

#include <cmath>

#include "geometry/shape/shape_extents.h"
#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

/// Far beyond any scale. Times a coordinate in single precision, it cannot overflow.
constexpr double kLargestLinearEntry = 1e30;
constexpr unsigned kAllRows = 7;  ///< one bit each

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

void addSolid(const Shape& shape, const Directions& linear, Extents& extents) {
  for (int k = 0; k < 3; ++k) {
    const double half = halfExtent(shape.solid, linear.row(k).transpose().cwiseProduct(shape.size));
    extents.low[k] -= half;
    extents.high[k] += half;
  }
}

/// Bit k is set where row k differs; NaN differs from everything.
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

/// Stores `linear` in `known` and computes the pads of its rows against rounding. False if an entry
/// is too large or not a number; most poses pass by the sum of all entries alone.
bool updatePads(const Directions& linear, ShapeExtents& known, Eigen::Vector3d& pads) {
  known.linear = linear;
  double magnitude = 0;
  for (int k = 0; k < 3; ++k) {
    const double entries =
        std::abs(known.linear(k, 0)) + std::abs(known.linear(k, 1)) + std::abs(known.linear(k, 2));
    pads[k] = entries * known.pad_per_entry + kUnderflowPad;
    magnitude += entries;
  }
  if (magnitude <= kLargestLinearEntry || isUsable(linear)) return true;
  known.linear.setConstant(std::numeric_limits<double>::quiet_NaN());
  return false;
}

/// Updates all three rows, from the given lists or from those found now. False, without extents, as
/// updatePads(). The look-up waits for memory, so the pads are computed between it and the scan:
/// after the scan, one link alone takes 1.07 times as long.
bool updateAll(const Shape& shape, const Directions& linear, const ListsOfRows* lists,
               ShapeExtents& known) {
  CellsOfRows cells;
  const bool looks_up = !lists && known.table.cells;
  if (looks_up) query().find(known.table, linear, cells);
  Eigen::Vector3d pads;
  if (!updatePads(linear, known, pads)) return false;
  if (looks_up) {
    scanLists(known.table, linear, listsOf(known.table, cells), known.extents);
  } else if (lists) {
    scanLists(known.table, linear, *lists, known.extents);
  } else if (shape.points) {
    known.extents = shape.points->extents(linear);
  } else {
    known.extents = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  }
  if (shape.solid != Solid::kNone) addSolid(shape, linear, known.extents);
  known.extents.low -= pads;
  known.extents.high += pads;
  return true;
}

/// Updates only the rows whose bits are set. The query needs three rows, so it takes one of these
/// again in place of each other row.
bool updateRows(const Shape& shape, const Directions& linear, unsigned rows, ShapeExtents& known) {
  Eigen::Matrix3d directions;
  for (int k = 0; k < 3; ++k)
    directions.row(k) = linear.row(rows & 1u << k ? k : __builtin_ctz(rows));
  ShapeExtents fresh = known;
  if (!updateAll(shape, directions, nullptr, fresh)) return false;
  for (int k = 0; k < 3; ++k) {
    if (!(rows & 1u << k)) continue;
    known.linear.row(k) = fresh.linear.row(k);
    known.extents.low[k] = fresh.extents.low[k];
    known.extents.high[k] = fresh.extents.high[k];
  }
  return true;
}

bool update(const Shape& shape, const Directions& linear, const ListsOfRows* lists,
            ShapeExtents& known) {
  if (lists) return updateAll(shape, linear, lists, known);
  const unsigned rows = changedRows(linear, known.linear);
  if (rows == 0) return true;
  return rows == kAllRows ? updateAll(shape, linear, nullptr, known)
                          : updateRows(shape, linear, rows, known);
}

bool isFinite(const Aabb& box) {
  return std::isfinite((box.max() - box.min()).sum()) ||
         (box.min().allFinite() && box.max().allFinite());
}

/// The pad of the translation is added here; the extents have theirs. Both corners are computed
/// before the box is written: otherwise the compiler must assume that the box and `known` may
/// overlap, and a box takes 7 % more time.
bool placeAt(const Shape& shape, const Eigen::Affine3d& world_from_shape, const ListsOfRows* lists,
             ShapeExtents& known, Aabb& box) {
  if (!update(shape, world_from_shape.linear(), lists, known)) return false;
  const Eigen::Vector3d translation = world_from_shape.translation();
  const Eigen::Vector3d pad = kRoundingPad * translation.cwiseAbs();
  const Eigen::Vector3d low = (translation - pad) + known.extents.low;
  const Eigen::Vector3d high = (translation + pad) + known.extents.high;
  box.min() = low;
  box.max() = high;
  return isFinite(box);
}

}  // namespace

/// The pad uses the largest size and |coordinate| of any axis, which is nearly that of each axis.
ShapeExtents::ShapeExtents(const Shape& shape)
    : pad_per_entry(kRoundingPad * shape.size.maxCoeff() / 2),
      is_in_link_frame(shape.link_from_shape.matrix() == Eigen::Matrix4d::Identity()) {
  if (!shape.points) return;
  if (shape.points->table()) table = shape.points->table()->lookup();
  const double magnitude = shape.points->magnitude().maxCoeff();
  pad_per_entry += (kRoundingPad + kPointTolerance) * magnitude;
}

bool isUsablePose(const Eigen::Affine3d& pose) {
  return pose.translation().allFinite() && isUsable(pose.linear());
}

bool prefetchCells(const Eigen::Affine3d& world_from_shape, const ShapeExtents& known,
                   CellsOfRows& cells) {
  if (!known.table.cells) return false;
  const auto linear = world_from_shape.linear();
  if (changedRows(linear, known.linear) != kAllRows) return false;
  findCells(known.table, linear, cells);
  return true;
}

bool placeShape(const Shape& shape, const Eigen::Affine3d& world_from_link,
                const ListsOfRows* lists, ShapeExtents& known, Aabb& box) {
  if (known.is_in_link_frame) return placeAt(shape, world_from_link, lists, known, box);
  return placeAt(shape, world_from_link * shape.link_from_shape, nullptr, known, box);
}

std::optional<Aabb> worldBox(const Shape& shape, const Eigen::Affine3d& world_from_link) {
  ShapeExtents nothing_known(shape);
  std::optional<Aabb> box(std::in_place);
  if (!placeShape(shape, world_from_link, nullptr, nothing_known, *box)) box.reset();
  return box;
}

}  // namespace link_bounds
