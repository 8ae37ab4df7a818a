// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of cells are halved until one class holds for all points of a block.
#include "geometry/cloud/body_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace link_bounds {
namespace {

constexpr std::size_t kCellsPerByte = 4;

/// Where the surface crosses a cell, each of its points must be nearer than the padding for the
/// cell to be decided: its diagonal must be shorter. Half the padding is so for a cube.
constexpr double kCellsPerPadding = 2;

/// More cells along the longest edge only take memory; fewer leave too much to decide.
constexpr double kMaxCellsPerEdge = 128;
constexpr double kMinCellsPerEdge = 16;

/// A point near the border of two cells may be looked up in either one, because rounding decides:
/// every block is larger by this part.
constexpr double kBlockPad = 1e-6;

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
  std::size_t done = 0;
  while (!open.empty()) {
    if (check_interrupt && ++done % 1024 == 0) check_interrupt();
    const Block block = open.back();
    open.pop_back();
    if (const auto cell = classOf(block)) {
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
}

/// Nothing if the block must be divided. A ball holds the block. If no point of the surface is in
/// the ball, all points of the block are on one side of it.
std::optional<BodyGrid::Cell> BodyGrid::classOf(const Block& block) const {
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
  const double near = padding_ - radius;
  const PointDistance found = surface_.distance(center, clear * (1 + kBlockPad) + 1e-9, near);
  if (found.upper <= near) return Cell::kBody;
  const bool is_on_one_side = found.lower > radius;
  if (found.lower > clear) return surface_.contains(center) ? Cell::kBody : Cell::kClear;
  if (!is_single) return std::nullopt;
  if (!is_on_one_side && surface_.hasInside()) return Cell::kByDistanceAndSide;
  return is_on_one_side && surface_.contains(center) ? Cell::kBody : Cell::kByDistance;
}

void BodyGrid::fill(const Block& block, Cell cell) {
  for (std::size_t z = block.begin[2]; z < block.end[2]; ++z) {
    for (std::size_t y = block.begin[1]; y < block.end[1]; ++y) {
      for (std::size_t x = block.begin[0]; x < block.end[0]; ++x) {
        const std::size_t index = (z * counts_[1] + y) * counts_[0] + x;
        cells_[index / kCellsPerByte] = static_cast<std::uint8_t>(
            cells_[index / kCellsPerByte] | static_cast<unsigned>(cell) << (index % 4 * 2));
        undecided_ += cell >= Cell::kByDistance;
      }
    }
  }
}

bool BodyGrid::decide(const Eigen::Vector3d& point, double slack, Cell cell) const {
  const double reach = padding_ + slack;
  const PointDistance found = surface_.distance(point, reach * (1 + 1e-9) + 1e-9, reach);
  if (found.lower <= reach) return true;
  return cell == Cell::kByDistanceAndSide && surface_.contains(point);
}

}  // namespace link_bounds
