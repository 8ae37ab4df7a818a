// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Magnitude, points that are kept, and the farthest point, for both ways in which points are kept.
#include "link_bounds/geometry/support/point_set.h"

#include <algorithm>
#include <array>

#include "geometry/support/query/direction_query.h"
#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

Eigen::Vector3d magnitudeOf(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector3f result = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& point : points)
    result = result.cwiseMax(point.cwiseAbs());
  return result.cast<double>();
}

using Coordinates = std::array<float, 3>;

std::vector<Coordinates> distinctPoints(const DirectionTable& table,
                                        const CheckInterrupt& check_interrupt) {
  std::vector<Coordinates> distinct;
  distinct.reserve(kLanes * (2 * table.lists.size() + table.overflow.size()));
  const auto add = [&distinct](const PointBlock& block) {
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      distinct.push_back({block.x[lane], block.y[lane], block.z[lane]});
  };
  for (const DirectionTable::List& list : table.lists) {
    add(list.blocks[0]);
    add(list.blocks[1]);
  }
  for (const PointBlock& block : table.overflow)
    add(block);
  WorkMeter meter(check_interrupt);
  std::sort(distinct.begin(), distinct.end(), [&meter](const Coordinates& a, const Coordinates& b) {
    meter.add(1);
    return a < b;
  });
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  return distinct;
}

/// Plain code: the dot products of a block are independent, so the compiler vectorises them.
struct FarthestLane {
  const PointBlock* block = nullptr;
  int lane = 0;
  double dot = 0;

  void add(const PointBlock& next, const Eigen::Vector3d& d) {
    double dots[4];
    for (int i = 0; i < 4; ++i)
      dots[i] = (d.x() * static_cast<double>(next.x[i]) + d.y() * static_cast<double>(next.y[i])) +
                d.z() * static_cast<double>(next.z[i]);
    const int low = dots[1] > dots[0] ? 1 : 0;
    const int high = dots[3] > dots[2] ? 3 : 2;
    const int best = dots[high] > dots[low] ? high : low;
    if (block && !(dots[best] > dot)) return;
    block = &next;
    lane = best;
    dot = dots[best];
  }
};

/// The first point of a cell's list with the largest d . p, evaluated as extents() does.
Eigen::Vector3d farthestPoint(const DirectionTable& table, const Eigen::Vector3d& direction) {
  const DirectionTable::Cell number =
      table.cells[cellOf(direction.x(), direction.y(), direction.z(), table.grid)];
  const DirectionTable::List& list = table.lists[number];
  FarthestLane farthest;
  farthest.add(list.blocks[0], direction);
  farthest.add(list.blocks[1], direction);
  if (number < table.rests.size()) {
    const DirectionTable::Rest rest = table.rests[number];
    for (std::uint32_t i = 0; i < rest.count; ++i)
      farthest.add(table.overflow[rest.first + i], direction);
  }
  const PointBlock& block = *farthest.block;
  const int lane = farthest.lane;
  return Eigen::Vector3f(block.x[lane], block.y[lane], block.z[lane]).cast<double>();
}

/// The same for points in double, as in PointSet.
Eigen::Vector3d farthestPoint(const double* xyz, std::size_t count,
                              const Eigen::Vector3d& direction) {
  const double* best = xyz;
  double best_dot = 0;
  for (const double* point = xyz; point != xyz + 3 * count; point += 3) {
    const double dot =
        (direction.x() * point[0] + direction.y() * point[1]) + direction.z() * point[2];
    if (point != xyz && !(dot > best_dot)) continue;
    best = point;
    best_dot = dot;
  }
  return Eigen::Vector3d(best[0], best[1], best[2]);
}

}  // namespace

PointSet::PointSet(const std::vector<Eigen::Vector3f>& points,
                   const CheckInterrupt& check_interrupt)
    : table_(std::make_shared<const DirectionTable>(
          directionTable(points, std::nullopt, check_interrupt))),
      magnitude_(magnitudeOf(points)),
      size_(distinctPoints(*table_, check_interrupt).size()) {}

PointSet::PointSet(const std::vector<Eigen::Vector3f>& points, std::size_t max_bytes,
                   const CheckInterrupt& check_interrupt)
    : table_(std::make_shared<const DirectionTable>(
          directionTable(points, max_bytes, check_interrupt))),
      magnitude_(magnitudeOf(points)),
      size_(distinctPoints(*table_, check_interrupt).size()) {}

PointSet::PointSet(std::shared_ptr<const double> xyz, std::size_t count)
    : xyz_(std::move(xyz)), magnitude_(scannedMagnitude(xyz_.get(), count)), size_(count) {}

Extents PointSet::extents(const Directions& directions) const {
  return table_ ? link_bounds::extents(*table_, directions)
                : scannedExtents(xyz_.get(), size_, directions);
}

Eigen::Vector3d PointSet::farthest(const Eigen::Vector3d& direction) const {
  return table_ ? farthestPoint(*table_, direction) : farthestPoint(xyz_.get(), size_, direction);
}

std::size_t PointSet::bytes() const {
  return sizeof(*this) + (table_ ? table_->bytes() : 3 * sizeof(double) * size_);
}

bool PointSet::isSame(const PointSet& other) const {
  if (this == &other) return true;
  return xyz_ && other.xyz_ && size_ == other.size_ &&
         std::equal(xyz_.get(), xyz_.get() + 3 * size_, other.xyz_.get());
}

std::vector<Eigen::Vector3f> PointSet::points() const {
  if (!table_) return {};
  std::vector<Eigen::Vector3f> result;
  for (const Coordinates& point : distinctPoints(*table_, nullptr))
    result.emplace_back(point[0], point[1], point[2]);
  return result;
}

std::vector<Eigen::Vector3d> PointSet::keptPoints() const {
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector3f& point : points())
    result.push_back(point.cast<double>());
  for (std::size_t i = 0; xyz_ && i < size_; ++i)
    result.emplace_back(xyz_.get() + 3 * i);
  return result;
}

}  // namespace link_bounds
