// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is known about all points, and which of the two ways they are kept.
#include "link_bounds/geometry/support/point_set.h"

#include <algorithm>
#include <array>

#include "geometry/support/query/direction_query.h"
#include "geometry/support/query/farthest_point.h"
#include "geometry/support/query/point_scan.h"

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

}  // namespace

PointSet::PointSet(const std::vector<Eigen::Vector3f>& points,
                   const CheckInterrupt& check_interrupt)
    : table_(std::make_shared<const DirectionTable>(directionTable(points, check_interrupt))),
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
