// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the grid, and packs its lists, which cells share, into blocks.
#include "geometry/support/table/direction_table.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "geometry/support/table/direction_build.h"
#include "geometry/support/table/direction_fold.h"

namespace link_bounds {
namespace {

/// directionTable() describes these limits. A list has eight points without overflow. None of 21
/// meshes of robots needs more than kBytesPerTable; half of it would make some grids coarser.
constexpr int kCoarsestGrid = 8;
constexpr int kFinestGrid = 64;
constexpr double kMeanListSize = 8;
constexpr std::size_t kBytesPerTable = 96 * 1024;
constexpr std::size_t kBytesPerPoint = 48;
/// A set of more than 2 * kPart points is first reduced part by part, in at most kPasses passes.
constexpr std::size_t kPart = 1 << 16;
constexpr int kPasses = 4;

/// A scan over this many points takes about as long as a look-up in a grid that is in no cache.
constexpr std::size_t kGriddedPoints = 64;

/// DirectionGrid::half is less than half the side by this share of it, so that no index is `side`,
/// also when it is rounded to 2^-kFraction.
constexpr double kGridMargin = 1.25e-7;
static_assert(kCoarsestGrid * kGridMargin > 0.5 / (1 << kFraction), "an index could be `side`");
static_assert(kFinestGrid < 1 << (50 - kFraction), "kShifter could not hold an index");
static_assert(kFinestGrid * kFinestGrid <= 1 << 16, "a cell could not hold the number of a list");

constexpr std::size_t kPointsInline = 2 * kLanes;

/// Four points of the list from `first` on; beyond its end the last point is repeated.
PointBlock blockOf(const std::vector<Eigen::Vector3f>& points, const PointIndices& list,
                   std::size_t first) {
  PointBlock block;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Eigen::Vector3f& point = points[list[std::min(first + lane, list.size() - 1)]];
    block.x[lane] = point.x();
    block.y[lane] = point.y();
    block.z[lane] = point.z();
  }
  return block;
}

void append(const std::vector<Eigen::Vector3f>& points, const PointIndices& list,
            DirectionTable& table) {
  table.lists.push_back({{blockOf(points, list, 0), blockOf(points, list, kLanes)}});
  if (list.size() <= kPointsInline) return;
  const auto first = static_cast<std::uint32_t>(table.overflow.size());
  for (std::size_t i = kPointsInline; i < list.size(); i += kLanes)
    table.overflow.push_back(blockOf(points, list, i));
  table.rests.push_back({first, static_cast<std::uint32_t>(table.overflow.size()) - first});
}

/// Few lists of points that serve many cells. Joins lists while they have at most `capacity` points
/// together. A cell may share its list, because further points of the set do no harm to a query.
class SharedLists {
 public:
  /// Indices of points are below `points`.
  SharedLists(std::size_t points, std::size_t capacity) : capacity_(capacity), lists_of_(points) {}

  /// Returns the number of a list that holds these points. Greedy: joins them to the list that
  /// grows by the fewest points; best called with longer lists first. Points that exceed the
  /// capacity get a list of their own. Only lists with the first or the last point are tried, which
  /// keeps the search short.
  std::uint32_t add(const PointIndices& points) {
    const auto fresh = static_cast<std::uint32_t>(lists_.size());
    if (points.size() > capacity_) {
      lists_.push_back(points);
      return fresh;
    }
    std::uint32_t best = fresh;
    std::size_t least = capacity_;
    for (const std::uint32_t point : {points.front(), points.back()}) {
      for (const std::uint32_t number : lists_of_[point]) {
        const std::size_t grown = growth(number, points);
        if (grown == 0) return number;
        if (grown >= least || lists_[number].size() + grown > capacity_) continue;
        best = number;
        least = grown;
      }
    }
    if (best == fresh) lists_.emplace_back();
    return join(best, points);
  }

  const std::vector<PointIndices>& lists() const { return lists_; }

 private:
  /// Number of points that would be new in the list.
  std::size_t growth(std::uint32_t number, const PointIndices& points) const {
    const PointIndices& list = lists_[number];
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&list](std::uint32_t point) {
          return std::find(list.begin(), list.end(), point) == list.end();
        }));
  }

  std::uint32_t join(std::uint32_t number, const PointIndices& points) {
    PointIndices& list = lists_[number];
    for (const std::uint32_t point : points) {
      if (std::find(list.begin(), list.end(), point) != list.end()) continue;
      list.push_back(point);
      lists_of_[point].push_back(number);
    }
    return number;
  }

  std::size_t capacity_;
  std::vector<PointIndices> lists_;
  std::vector<std::vector<std::uint32_t>> lists_of_;  ///< by point
};

/// By list of a cell: the number of the shared list that serves it.
using ListNumbers = std::map<PointIndices, std::uint32_t>;

/// Shares the longest lists first, so that the lists with overflow have the smallest numbers.
void share(ListNumbers& numbers, SharedLists& shared) {
  std::vector<ListNumbers::value_type*> order;
  for (ListNumbers::value_type& entry : numbers)
    order.push_back(&entry);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->first.size() > b->first.size(); });
  for (ListNumbers::value_type* entry : order)
    entry->second = shared.add(entry->first);
}

DirectionTable packed(const std::vector<Eigen::Vector3f>& points, const CandidateGrid& grid) {
  std::vector<ListNumbers::iterator> cells;
  ListNumbers numbers;
  for (const CellCandidates& cell : grid.cells)
    cells.push_back(numbers.emplace(cell.all(), 0).first);
  SharedLists shared(points.size(), kPointsInline);
  share(numbers, shared);

  DirectionTable table;
  table.grid = DirectionGrid(grid.grid);
  table.cells.reserve(cells.size());
  for (const ListNumbers::iterator cell : cells)
    table.cells.push_back(static_cast<DirectionTable::Cell>(cell->second));
  table.lists.reserve(shared.lists().size());
  for (const PointIndices& list : shared.lists())
    append(points, list, table);
  table.rests.shrink_to_fit();
  table.overflow.shrink_to_fit();
  return table;
}

std::vector<Eigen::Vector3d> toDouble(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(points.size());
  for (const Eigen::Vector3f& point : points)
    result.push_back(point.cast<double>());
  return result;
}

/// One cell with all points, so that a query is a plain scan.
CandidateGrid listOfAll(std::size_t count) {
  CandidateGrid result{1, {CellCandidates()}};
  result.cells[0].upper.resize(count);
  std::iota(result.cells[0].upper.begin(), result.cells[0].upper.end(), 0u);
  return result;
}

/// The grid of 8, the first one with minimal lists.
CandidateGrid coarsestLists(GridBuilder& builder) {
  CandidateGrid grid = builder.coarsest();
  while (grid.grid < kCoarsestGrid)
    grid = builder.refined(grid);
  return grid;
}

std::vector<Eigen::Vector3f> named(const std::vector<Eigen::Vector3f>& points, Effort effort,
                                   const CheckInterrupt& check_interrupt) {
  GridBuilder builder(toDouble(points), effort, check_interrupt);
  std::vector<Eigen::Vector3f> result;
  for (const std::uint32_t index : coarsestLists(builder).named())
    result.push_back(points[index]);
  return result;
}

/// The points of a large set that can be extreme in their part. A part fits into the cache. Once
/// most points of a part can be extreme, little is gained by examining the next parts as closely.
std::vector<Eigen::Vector3f> reducedByParts(const std::vector<Eigen::Vector3f>& points,
                                            const CheckInterrupt& check_interrupt) {
  std::vector<Eigen::Vector3f> left;
  Effort effort = Effort::kMinimal;
  for (std::size_t first = 0; first < points.size(); first += kPart) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto size = std::min(kPart, points.size() - first);
    const std::vector<Eigen::Vector3f> part =
        named({begin, begin + static_cast<std::ptrdiff_t>(size)}, effort, check_interrupt);
    left.insert(left.end(), part.begin(), part.end());
    if (2 * part.size() > size) effort = Effort::kQuick;
  }
  return left;
}

Effort effortFor(std::size_t points) {
  return points > 2 * kPart ? Effort::kQuick : Effort::kMinimal;
}

bool isWithinLimit(const DirectionTable& table, const CandidateGrid& grid) {
  return table.bytes() <= std::max(kBytesPerTable, kBytesPerPoint * grid.named().size());
}

DirectionTable wholeTable(const std::vector<Eigen::Vector3f>& points, CandidateGrid grid,
                          GridBuilder& builder) {
  DirectionTable table = packed(points, grid);
  // The search ends at the first table above the limit.
  while (isWithinLimit(table, grid) && grid.meanListSize() > kMeanListSize &&
         grid.grid < kFinestGrid) {
    grid = builder.refined(grid);
    DirectionTable finer = packed(points, grid);
    if (!isWithinLimit(finer, grid)) break;
    table = std::move(finer);
  }
  return table;
}

DirectionTable smallTable(const std::vector<Eigen::Vector3f>& points, const CandidateGrid& grid,
                          std::size_t max_bytes) {
  const PointIndices named = grid.named();
  if (named.size() > kGriddedPoints) {
    DirectionTable table = packed(points, grid);
    if (table.bytes() <= max_bytes) return table;
  }
  CandidateGrid list = listOfAll(0);
  list.cells[0].upper = named;
  return packed(points, list);
}

/// Drops points of a large set that cannot be extreme; leaves a small set as it is.
std::vector<Eigen::Vector3f> reduced(const std::vector<Eigen::Vector3f>& points, int passes,
                                     const CheckInterrupt& check_interrupt) {
  if (passes == 0 || points.size() <= 2 * kPart) return points;
  const std::vector<Eigen::Vector3f> left = reducedByParts(points, check_interrupt);
  return reduced(left, 2 * left.size() < points.size() ? passes - 1 : 0, check_interrupt);
}

}  // namespace

DirectionTable directionTable(const std::vector<Eigen::Vector3f>& points,
                              std::optional<std::size_t> max_bytes,
                              const CheckInterrupt& check_interrupt) {
  const std::vector<Eigen::Vector3f> left = reduced(points, kPasses, check_interrupt);
  if (left.size() <= kScannedPoints) return packed(left, listOfAll(left.size()));
  GridBuilder builder(toDouble(left), effortFor(left.size()), check_interrupt);
  CandidateGrid grid = coarsestLists(builder);
  if (max_bytes) return smallTable(left, grid, *max_bytes);
  return wholeTable(left, std::move(grid), builder);
}

DirectionGrid::DirectionGrid(int cells_per_side)
    : side(cells_per_side),
      log2_side(__builtin_ctz(static_cast<unsigned>(cells_per_side))),
      mask(static_cast<unsigned>(cells_per_side * cells_per_side - 1)),
      half(cells_per_side * (0.5 - kGridMargin)) {}

std::size_t DirectionTable::bytes() const {
  return sizeof(*this) + cells.capacity() * sizeof(Cell) + lists.capacity() * sizeof(List) +
         rests.capacity() * sizeof(Rest) + overflow.capacity() * sizeof(PointBlock);
}

}  // namespace link_bounds
