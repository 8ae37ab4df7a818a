// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of cells are halved until one class holds for all points of a block; then regions of cells
// that no surface divides are found to be inside or outside.
#include "geometry/cloud/body_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace link_bounds {
namespace {

constexpr std::size_t kCellsPerByte = 4;

/// A cell that the surface crosses is decided as a whole only if all its points are nearer than the
/// padding, so its diagonal must be shorter. A cube with half the padding as its edge satisfies
/// that.
constexpr double kCellsPerPadding = 2;

/// More cells along the longest edge only take memory; with fewer, too many points need their
/// distance computed.
constexpr double kMaxCellsPerEdge = 128;
constexpr double kMinCellsPerEdge = 16;

/// Rounding decides in which of two adjacent cells a point near their border is looked up, so every
/// block is enlarged by this fraction.
constexpr double kBlockPad = 1e-6;

/// Max number of cells of a region that cast rays, since rays may pass too close to an edge.
constexpr std::size_t kMaxTries = 16;

}  // namespace

BodyGrid::BodyGrid(BodySurface surface, const GridOptions& options,
                   const CheckInterrupt& check_interrupt)
    : surface_(std::move(surface)), padding_(options.padding), max_slack_(options.max_slack) {
  if (surface_.box().isEmpty()) return;
  const double magnitude =
      surface_.box().min().cwiseAbs().cwiseMax(surface_.box().max().cwiseAbs()).maxCoeff();
  box_ = padded(surface_.box(), padding_ + max_slack_ + 1e-6 + 1e-12 * magnitude);
  if (!box_.sizes().allFinite()) {
    box_.setEmpty();
    return;
  }
  layOut(options.max_bytes);
  build(check_interrupt);
}

void BodyGrid::layOut(std::size_t max_bytes) {
  const Eigen::Vector3d size = box_.sizes();
  const double longest = size.maxCoeff();
  cell_ = std::clamp(padding_ / kCellsPerPadding, longest / kMaxCellsPerEdge,
                     longest / kMinCellsPerEdge);
  const auto count = [&](int axis) {
    return static_cast<std::size_t>(std::ceil(size[axis] / cell_ * (1 + kBlockPad))) + 1;
  };
  while ((count(0) * count(1) * count(2) + kCellsPerByte - 1) / kCellsPerByte > max_bytes)
    cell_ *= 1.05;
  per_cell_ = 1 / cell_;
  for (std::size_t k = 0; k < 3; ++k) {
    counts_[k] = count(static_cast<int>(k));
    end_[static_cast<int>(k)] = static_cast<double>(counts_[k]);
  }
  origin_ = box_.min();
  cells_.assign((cells() + kCellsPerByte - 1) / kCellsPerByte, 0);
}

void BodyGrid::build(const CheckInterrupt& check_interrupt) {
  std::vector<Block> open{{{{0, 0, 0}}, counts_}};
  BodySurface::Hint hint;
  std::size_t done = 0;
  while (!open.empty()) {
    if (check_interrupt && ++done % 1024 == 0) check_interrupt();
    const Block block = open.back();
    open.pop_back();
    if (const auto cell = classOf(block, hint)) {
      fill(block, *cell);
      continue;
    }
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (block.end[k] - block.begin[k] > block.end[longest] - block.begin[longest]) longest = k;
    }
    Block left = block, right = block;
    left.end[longest] = right.begin[longest] = (block.begin[longest] + block.end[longest]) / 2;
    open.push_back(left);
    open.push_back(right);
  }
  if (surface_.hasInside()) findSides(check_interrupt);
}

/// The class of all points of the block; nothing if the block must be divided. Uses a ball around
/// the block: if no point of the surface is in the ball, all points of the block are on the same
/// side of the surface.
std::optional<BodyGrid::Cell> BodyGrid::classOf(const Block& block, BodySurface::Hint& hint) const {
  Eigen::Vector3d center, half;
  bool is_single = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto begin = static_cast<double>(block.begin[k]), end = static_cast<double>(block.end[k]);
    const auto axis = static_cast<int>(k);
    center[axis] = origin_[axis] + (begin + end) / 2 * cell_;
    half[axis] = (end - begin) / 2 * cell_;
    is_single &= block.end[k] - block.begin[k] == 1;
  }
  const double radius = half.norm() * (1 + kBlockPad) + 1e-12 * center.cwiseAbs().maxCoeff();
  const double clear = padding_ + max_slack_ + radius;
  // A block is divided as soon as one point of the surface is near.
  const double near = is_single ? padding_ - radius : clear;
  const PointDistance found =
      surface_.distance(center, clear * (1 + kBlockPad) + 1e-9, near, &hint);
  if (found.lower > clear) return Cell::kClear;
  if (!is_single) return std::nullopt;
  if (found.upper <= near) return Cell::kBody;
  const bool is_on_one_side = found.lower > radius || !surface_.hasInside();
  return is_on_one_side ? Cell::kByDistance : Cell::kByDistanceAndSide;
}

void BodyGrid::fill(const Block& block, Cell cell) {
  for (std::size_t z = block.begin[2]; z < block.end[2]; ++z) {
    for (std::size_t y = block.begin[1]; y < block.end[1]; ++y) {
      for (std::size_t x = block.begin[0]; x < block.end[0]; ++x)
        set(indexOf(x, y, z), cell);
    }
  }
}

/// No surface crosses a cell of class kClear or kByDistance, so neighbours of these classes are on
/// the same side: one ray decides for a region of them.
void BodyGrid::findSides(const CheckInterrupt& check_interrupt) {
  std::vector<bool> is_seen(cells(), false);
  for (std::size_t i = 0; i < cells(); ++i) {
    if (check_interrupt && i % 1024 == 0) check_interrupt();
    if (is_seen[i] || !isOnOneSide(at(i))) continue;
    const std::vector<std::size_t> region = regionAt(i, is_seen);
    if (!isInside(region)) continue;
    for (const std::size_t index : region)
      set(index, Cell::kBody);
  }
}

/// All cells that are connected with this one without crossing the surface; this one comes first.
std::vector<std::size_t> BodyGrid::regionAt(std::size_t index, std::vector<bool>& is_seen) const {
  std::vector<std::size_t> region{index};
  is_seen[index] = true;
  const std::array<std::size_t, 3> steps{1, counts_[0], counts_[0] * counts_[1]};
  for (std::size_t i = 0; i < region.size(); ++i) {
    const std::size_t cell = region[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t place = cell / steps[k] % counts_[k];
      const auto visit = [&](std::size_t next) {
        if (is_seen[next] || !isOnOneSide(at(next))) return;
        is_seen[next] = true;
        region.push_back(next);
      };
      if (place > 0) visit(cell - steps[k]);
      if (place + 1 < counts_[k]) visit(cell + steps[k]);
    }
  }
  return region;
}

/// If the rays from several cells are all unsure, the region counts as inside.
bool BodyGrid::isInside(const std::vector<std::size_t>& region) const {
  for (std::size_t i = 0; i < std::min(region.size(), kMaxTries); ++i) {
    if (const auto is_inside = surface_.contains(centerOf(region[i]))) return *is_inside;
  }
  return true;
}

Eigen::Vector3d BodyGrid::centerOf(std::size_t index) const {
  const Eigen::Vector3d place(static_cast<double>(index % counts_[0]),
                              static_cast<double>(index / counts_[0] % counts_[1]),
                              static_cast<double>(index / (counts_[0] * counts_[1])));
  return origin_ + (place.array() + 0.5).matrix() * cell_;
}

bool BodyGrid::decide(const Eigen::Vector3d& point, double slack, Cell cell) const {
  const double max_distance = padding_ + slack;
  const PointDistance found =
      surface_.distance(point, max_distance * (1 + 1e-9) + 1e-9, max_distance);
  if (found.lower <= max_distance) return true;
  return cell == Cell::kByDistanceAndSide && surface_.contains(point).value_or(true);
}

}  // namespace link_bounds
