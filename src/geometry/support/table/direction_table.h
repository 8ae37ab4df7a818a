// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// How far a rigid set of points extends along any direction, from a few points instead of all, and
/// exact but for kTableTolerance.
///
/// The world box of a turned mesh needs six numbers: for each row r of the linear part of its pose,
/// the smallest and the largest r . p over the points p. The paper (doc/paper.md) finds them by
/// looping over all vertices at each update. But which vertices can win depends on the direction of
/// r alone, and that can be prepared once, when the mesh is loaded:
///
///   1. Fold. r and -r have the same extreme points, so half of all directions suffice. The half
///      sphere is flattened to a square (the octahedral map: x, y, z divided by |x| + |y| + |z|,
///      turned by 45 degrees) and the square is cut into grid x grid cells.
///   2. Build. Each cell gets the list of the points that are extreme for any direction in it; a
///      point that others beat in the whole cell is left out. Most vertices of a mesh are in no
///      list. Cells share lists as long as eight points suffice, which saves two thirds of the
///      memory (`scripts/bench core`: a median of 33 KiB instead of 107).
///   3. Query. Three rows, three cells, and a scan over a handful of points each.
///
/// Nothing in this is approximate: the winner for a direction is in the list of the direction's
/// cell, and its r . p is evaluated as the loop over all vertices would. It holds for every linear
/// map (scaled, mirrored, sheared, flat), keeps no state, and needs no convex hull, so degenerate
/// sets (a point, a line, a plane) are nothing special. A conservative relative of this table is
/// the apex point map of Laine and Karras (2015).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "link_bounds/geometry/check_interrupt.h"

namespace link_bounds {

constexpr std::size_t kLanes = 4;

/// Four points, laid out for vector instructions. Unused places repeat a point.
struct PointBlock {
  float x[kLanes];
  float y[kLanes];
  float z[kLanes];
};

/// The cells of the square, with numbers that a query would otherwise compute.
struct DirectionGrid {
  /// `cells_per_side` is a power of 2; 1 makes one list of all points.
  explicit DirectionGrid(int cells_per_side = 1);

  int side;
  int log2_side;
  unsigned mask;  ///< the bits of a cell's index
  /// side / 2, less a margin, so that an index stays below `side` although it is rounded to the
  /// nearest 2^-kFraction (direction_fold.h).
  double half;
};

/// Immutable once built, so any number of threads may query it.
struct DirectionTable {
  using Cell = std::uint16_t;  ///< index of the list of a cell

  /// Eight points, in two lines of the cache.
  struct alignas(32) List {
    PointBlock blocks[2];
  };

  /// The further blocks of a list, in `overflow`.
  struct Rest {
    std::uint32_t first;
    std::uint32_t count;
  };

  DirectionGrid grid;
  std::vector<Cell> cells;  ///< side * side, row by row
  std::vector<List> lists;
  std::vector<Rest> rests;  ///< of lists of more than eight points, which come first
  std::vector<PointBlock> overflow;

  /// The members that queries read. A caller keeps them where its query begins, which saves a cache
  /// miss for the table itself. Valid until the table is moved or destroyed.
  struct Lookup {
    DirectionGrid grid;
    const Cell* cells = nullptr;
    const List* lists = nullptr;
    const Rest* rests = nullptr;
    std::size_t rest_count = 0;
    const PointBlock* overflow = nullptr;
  };

  Lookup lookup() const {
    return {grid, cells.data(), lists.data(), rests.data(), rests.size(), overflow.data()};
  }

  /// Bytes kept in memory.
  std::size_t bytes() const;
};

/// Relative to the largest |coordinate| times |r|_1, see directionTable().
constexpr double kTableTolerance = 1e-14;

/// As much again covers rounding in double while lists are made and extents are evaluated.
constexpr double kPointTolerance = 2 * kTableTolerance;

/// `points` must be finite and not empty. A point may be left out if others extend as far to within
/// kTableTolerance, and to rounding; worldBox adds a pad for that. At most
/// `kScannedPoints` points go into one list. Otherwise the grid is the coarsest of 8, 16, 32 and 64
/// with at most 8 points per list on average, or the last one before a table takes more memory than
/// 96 KiB or 48 bytes per point that can be extreme, whichever is more.
///
/// Where more than 131,072 points can be extreme, as for a ball with a fine mesh, lists name some
/// more points than they need: making them minimal would take 10 us per point. A query is as exact.
///
/// With `max_bytes` it takes less memory, for a set that is one of many: a grid of 8 if there are
/// many points and it takes no more than that, else one list of all points that can be extreme.
DirectionTable directionTable(const std::vector<Eigen::Vector3f>& points,
                              std::optional<std::size_t> max_bytes = std::nullopt,
                              const CheckInterrupt& check_interrupt = nullptr);

constexpr std::size_t kScannedPoints = 16;

}  // namespace link_bounds
