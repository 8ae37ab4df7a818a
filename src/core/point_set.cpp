// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is known about all points, and which of the two ways they are kept.
#include "link_bounds/point_set.h"

#include <algorithm>
#include <array>
#include <set>

#include "point_scan.h"

namespace link_bounds {
namespace {

Eigen::Vector3d magnitudeOf(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector3f result = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& point : points)
    result = result.cwiseMax(point.cwiseAbs());
  return result.cast<double>();
}

}  // namespace

PointSet::PointSet(const std::vector<Eigen::Vector3f>& points)
    : table_(directionTable(points)),
      magnitude_(magnitudeOf(points)),
      size_(this->points().size()) {}

PointSet::PointSet(const DoublePoints& points)
    : lanes_(packed(points, magnitude_)), size_(static_cast<std::size_t>(points.cols())) {}

Extents PointSet::scan(const Directions& directions) const {
  return scannedExtents(lanes_, directions);
}

std::size_t PointSet::bytes() const {
  return sizeof(*this) - sizeof(table_) + table_.bytes() +
         static_cast<std::size_t>(lanes_.size()) * sizeof(double);
}

std::vector<Eigen::Vector3f> PointSet::points() const {
  std::set<std::array<float, 3>> distinct;
  const auto insert = [&distinct](const PointBlock& block) {
    for (int lane = 0; lane < 4; ++lane)
      distinct.insert({block.x[lane], block.y[lane], block.z[lane]});
  };
  for (const DirectionTable::Cell& cell : table_.cells) {
    insert(cell.near[0]);
    insert(cell.near[1]);
  }
  for (const PointBlock& block : table_.more)
    insert(block);
  std::vector<Eigen::Vector3f> result;
  for (const std::array<float, 3>& point : distinct)
    result.emplace_back(point[0], point[1], point[2]);
  return result;
}

std::vector<Eigen::Vector3d> PointSet::keptPoints() const {
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector3f& point : points())
    result.push_back(point.cast<double>());
  for (Eigen::Index first = 0; first < lanes_.cols(); first += 3) {
    for (Eigen::Index lane = 0; lane < lanes_.rows(); ++lane)
      result.emplace_back(lanes_.block<1, 3>(lane, first).transpose());
  }
  return result;
}

}  // namespace link_bounds
