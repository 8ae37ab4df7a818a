// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of points that can be extreme in each cell of a grid, refined from grid to grid.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/support/table/direction_envelope.h"

namespace link_bounds {

/// The points that can be extreme for directions of one cell.
struct CellCandidates {
  PointIndices upper;  ///< for the largest p . d
  PointIndices lower;  ///< for the smallest

  /// The points of both, each once, in ascending order.
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

/// Lists for grids of 2, 4, 8 ... cells per side. With Effort::kMinimal, lists are minimal from 8
/// cells per side on; those of coarser grids lack only points that are cheap to rule out.
class GridBuilder {
 public:
  /// `check_interrupt` is called about once a millisecond.
  GridBuilder(std::vector<Eigen::Vector3d> points, Effort effort,
              const CheckInterrupt& check_interrupt);

  /// Not copyable, because envelope_ refers to points_.
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
