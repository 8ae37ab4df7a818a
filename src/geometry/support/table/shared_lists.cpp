// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Greedy: the list that grows least by the points. Only those with the first or the last point are
// tried, which keeps the search short.
#include "geometry/support/table/shared_lists.h"

#include <algorithm>

namespace link_bounds {

std::uint32_t SharedLists::add(const PointIndices& points) {
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

/// By how many points the list would grow.
std::size_t SharedLists::growth(std::uint32_t number, const PointIndices& points) const {
  const PointIndices& list = lists_[number];
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&list](std::uint32_t point) {
        return std::find(list.begin(), list.end(), point) == list.end();
      }));
}

std::uint32_t SharedLists::join(std::uint32_t number, const PointIndices& points) {
  PointIndices& list = lists_[number];
  for (const std::uint32_t point : points) {
    if (std::find(list.begin(), list.end(), point) != list.end()) continue;
    list.push_back(point);
    lists_of_[point].push_back(number);
  }
  return number;
}

}  // namespace link_bounds
