// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Every path of instructions looks into the same cell, also on the borders between cells.
#include "geometry/support/query/direction_query.h"

#include <gtest/gtest.h>

#include "geometry/support/table/direction_fold.h"
#include "testing/brute_force.h"

namespace link_bounds {
namespace {

constexpr int kDirections = 300'000;  // per grid

/// Points that differ from cell to cell, so that the extents tell which one was read.
DirectionTable telltale(int cells_per_side) {
  DirectionTable table;
  table.grid = DirectionGrid(cells_per_side);
  for (int i = 0; i < cells_per_side * cells_per_side; ++i) {
    const float size = static_cast<float>(i + 1);
    const PointBlock block{{size, 0, 0, 0}, {0, size, 0, 0}, {0, 0, size, 0}};
    table.lists.push_back({{block, block}});
    table.cells.push_back(static_cast<DirectionTable::Cell>(i));
  }
  return table;
}

/// Where the query rounds from one column or row to the next, or as near as between 1e-18 and 1e-6.
double borderCoordinate(const DirectionGrid& grid, brute_force::Random& random) {
  const double border = std::floor(random.uniform(0, grid.side + 1));
  const double offset = random.sign() > 0 ? 0 : random.sign() * random.magnitude(-18, -6);
  return std::clamp((border - grid.half) / grid.half + offset, -1.0, 1.0);
}

Eigen::Vector3d gridBorderDirection(const DirectionGrid& grid, brute_force::Random& random) {
  double s = borderCoordinate(grid, random);
  double t = random.sign() > 0 ? random.uniform(-1, 1) : borderCoordinate(grid, random);
  if (random.sign() > 0) std::swap(s, t);
  const double length = random.sign() * random.magnitude(-3, 3);
  return length * directionAt(s, t, faceAt(s, t));
}

TEST(DirectionQuery, EveryPathReadsTheSameCellOnAndBesideBorders) {
  brute_force::Random random(1);
  for (const int side : {8, 16, 32, 64}) {
    const DirectionTable table = telltale(side);
    int different = 0;
    for (int i = 0; i < kDirections; i += 3) {
      Eigen::Matrix3d rows;
      for (int k = 0; k < 3; ++k)
        rows.row(k) = gridBorderDirection(table.grid, random);
      useQueryPath(QueryPath::kPlain);
      const Extents plain = extents(table, rows);
      for (const QueryPath path : kQueryPaths) {
        if (!isSupported(path)) continue;
        useQueryPath(path);
        const Extents other = extents(table, rows);
        for (int k = 0; k < 3; ++k)
          different += plain.low[k] == other.low[k] && plain.high[k] == other.high[k] ? 0 : 1;
      }
    }
    EXPECT_EQ(different, 0) << "of " << kDirections << " directions, " << side << " cells a side";
  }
}

TEST(DirectionQuery, ThePathInUseIsTheOneThatWasChosen) {
  EXPECT_TRUE(isSupported(queryPath()));
  for (const QueryPath path : kQueryPaths) {
    if (!isSupported(path)) continue;
    useQueryPath(path);
    EXPECT_EQ(queryPath(), path);
  }
}

}  // namespace
}  // namespace link_bounds
