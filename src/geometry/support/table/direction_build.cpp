// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A quadtree of cells: cheap dominance on the way down, exact envelopes where lists are used.
#include "geometry/support/table/direction_build.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/support/table/direction_dominance.h"
#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

/// A list passes through at most eight envelopes (four of large sets in parts, then grids of 8, 16,
/// 32 and 64). Each may drop points that exceed the others by less than this share of the largest
/// |coordinate|, as computed: the difference of two dot products errs by less than 7e-16 of it. The
/// assertion counts the shares alone. The errors of eight envelopes, 5.6e-15, are left to the
/// second kTableTolerance that every user of a table adds.
constexpr double kTolerance = 1.25e-15;
static_assert(8 * kTolerance <= kTableTolerance, "a table could leave out too much");

/// Each cell is enlarged by this on every side, because rounding may put a direction into the
/// neighbouring cell.
constexpr double kGrowth = 2e-6;

/// The coarsest grid with envelopes. Coarser ones only lead to it, and drop only points that a
/// single other point dominates. With envelopes from grid 2 on, tables of robots take 1.4 times as
/// many instructions.
constexpr int kCoarsestEnvelope = 8;

/// The square of a cell in the coordinates of the fold.
struct CellSquare {
  CellSquare(int column, int row, int grid)
      : s_low(-1 + 2.0 * column / grid - kGrowth),
        s_high(-1 + 2.0 * (column + 1) / grid + kGrowth),
        t_low(-1 + 2.0 * row / grid - kGrowth),
        t_high(-1 + 2.0 * (row + 1) / grid + kGrowth) {}

  double s_low, s_high, t_low, t_high;
};

/// The directions at the given corners of the square (bit 0: high s, bit 1: high t), by the linear
/// map of the face in which their middle lies.
template <std::size_t count>
Cone coneThrough(const CellSquare& square, const std::array<int, count>& corners) {
  std::array<Eigen::Vector2d, count> places;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = {corners[i] & 1 ? square.s_high : square.s_low,
                 corners[i] & 2 ? square.t_high : square.t_low};
    middle += places[i] / static_cast<double>(count);
  }
  Cone cone;
  for (const Eigen::Vector2d& place : places)
    cone.push_back(directionAt(place.x(), place.y(), faceAt(middle.x(), middle.y())));
  return cone;
}

/// A cell as one flat cone, or as two where a diagonal of the square runs through it.
std::vector<Cone> conesOf(int column, int row, int grid) {
  const CellSquare square(column, row, grid);
  if (column == row) {
    return {coneThrough<3>(square, {0, 1, 3}), coneThrough<3>(square, {0, 3, 2})};
  }
  if (column + row == grid - 1) {
    return {coneThrough<3>(square, {0, 1, 2}), coneThrough<3>(square, {1, 3, 2})};
  }
  return {coneThrough<4>(square, {0, 1, 3, 2})};
}

/// All edges of the cones: a linear function that is smaller at each of them is smaller in the
/// whole cell.
Cone cornersOf(const std::vector<Cone>& cones) {
  Cone corners;
  for (const Cone& cone : cones)
    corners.insert(corners.end(), cone.begin(), cone.end());
  return corners;
}

double largestMagnitude(const std::vector<Eigen::Vector3d>& points) {
  double largest = 0;
  for (const Eigen::Vector3d& point : points)
    largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
  return largest;
}

void sortUnique(PointIndices& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

}  // namespace

PointIndices CellCandidates::all() const {
  PointIndices result = upper;
  result.insert(result.end(), lower.begin(), lower.end());
  sortUnique(result);
  return result;
}

double CandidateGrid::meanListSize() const {
  std::size_t sum = 0;
  for (const CellCandidates& cell : cells)
    sum += cell.all().size();
  return static_cast<double>(sum) / static_cast<double>(cells.size());
}

PointIndices CandidateGrid::named() const {
  PointIndices result;
  for (const CellCandidates& cell : cells) {
    result.insert(result.end(), cell.upper.begin(), cell.upper.end());
    result.insert(result.end(), cell.lower.begin(), cell.lower.end());
  }
  sortUnique(result);
  return result;
}

GridBuilder::GridBuilder(std::vector<Eigen::Vector3d> points, Effort effort,
                         const CheckInterrupt& check_interrupt)
    : points_(std::move(points)),
      tolerance_(kTolerance * largestMagnitude(points_)),
      meter_(check_interrupt),
      envelope_(points_, tolerance_, effort, meter_) {}

CandidateGrid GridBuilder::coarsest() {
  CellCandidates everything;
  everything.upper.resize(points_.size());
  std::iota(everything.upper.begin(), everything.upper.end(), 0u);
  everything.lower = everything.upper;
  return refined({1, {everything}});
}

CandidateGrid GridBuilder::refined(const CandidateGrid& parent) {
  const int grid = 2 * parent.grid;
  CandidateGrid result{grid, {}};
  result.cells.reserve(static_cast<std::size_t>(grid) * static_cast<std::size_t>(grid));
  for (int row = 0; row < grid; ++row) {
    for (int column = 0; column < grid; ++column) {
      const auto above = static_cast<std::size_t>(row / 2 * parent.grid + column / 2);
      result.cells.push_back(reduced(parent.cells[above], column, row, grid));
    }
  }
  return result;
}

CellCandidates GridBuilder::reduced(const CellCandidates& candidates, int column, int row,
                                    int grid) {
  meter_.add(candidates.upper.size() + candidates.lower.size());
  const std::vector<Cone> cones = conesOf(column, row, grid);
  const Cone corners = cornersOf(cones);
  CellCandidates left = candidates;
  dropDominated(points_, corners, 1, tolerance_, left.upper);
  dropDominated(points_, corners, -1, tolerance_, left.lower);
  if (grid < kCoarsestEnvelope) return left;
  return {envelope_.neededOf(left.upper, cones, 1), envelope_.neededOf(left.lower, cones, -1)};
}

}  // namespace link_bounds
