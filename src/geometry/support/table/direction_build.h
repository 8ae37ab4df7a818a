// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of points that can be extreme in each cell of a grid, refined from grid to grid.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/support/table/direction_envelope.h"

namespace link_bounds {

/// What can be extreme in one cell.
struct CellCandidates {
  PointIndices upper;  ///< for the largest p . d
  PointIndices lower;  ///< for the smallest

  /// Both, each point once, in ascending order.
  PointIndices all() const;
};

/// grid * grid cells over the square of direction_fold.h, row by row.
struct CandidateGrid {
  int grid = 0;
  std::vector<CellCandidates> cells;

  double meanListSize() const;
  /// The points that the lists name, each once.
  PointIndices named() const;
};

/// Lists for grids of 2, 4, 8 ... cells per side. With Effort::kMinimal they are minimal from 8 on;
/// the coarser ones lack only the points that are cheap to rule out.
class GridBuilder {
 public:
  /// `check_interrupt` is called about once a millisecond.
  GridBuilder(std::vector<Eigen::Vector3d> points, Effort effort,
              const CheckInterrupt& check_interrupt);

  /// The envelope refers to the points.
  GridBuilder(const GridBuilder&) = delete;
  GridBuilder& operator=(const GridBuilder&) = delete;

  CandidateGrid coarsest();
  CandidateGrid refined(const CandidateGrid& parent);

 private:
  CellCandidates reduced(const CellCandidates& candidates, int column, int row, int grid);

  std::vector<Eigen::Vector3d> points_;
  double tolerance_;
  WorkMeter meter_;
  Envelope envelope_;
};

}  // namespace link_bounds
