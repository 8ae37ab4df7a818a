// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Few lists of points that serve many cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/support/table/direction_envelope.h"

namespace link_bounds {

/// Joins lists while they have at most `capacity` points together. A cell may share its list,
/// because further points of the set do no harm to a query.
class SharedLists {
 public:
  /// Points of lists are less than `points`.
  SharedLists(std::size_t points, std::size_t capacity) : capacity_(capacity), lists_of_(points) {}

  /// The number of a list that holds these points. Longer ones first join best. What is longer than
  /// the capacity stays alone.
  std::uint32_t add(const PointIndices& points);

  const std::vector<PointIndices>& lists() const { return lists_; }

 private:
  std::size_t growth(std::uint32_t number, const PointIndices& points) const;
  std::uint32_t join(std::uint32_t number, const PointIndices& points);

  std::size_t capacity_;
  std::vector<PointIndices> lists_;
  std::vector<std::vector<std::uint32_t>> lists_of_;  ///< by point
};

}  // namespace link_bounds
