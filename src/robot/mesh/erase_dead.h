// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Keeps maps of meshes small, because clients may send new names without end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace link_bounds {

/// Up to this size, a map is not searched for dead entries.
constexpr std::size_t kManyMeshes = 10000;

/// Once the map has `limit` entries, erases those whose value `is_dead`. The limit becomes twice
/// the number of entries left, but at least kManyMeshes, so on average an insertion costs only a
/// few looks.
template <class Map, class IsDead>
void eraseDead(Map& map, std::size_t& limit, const IsDead& is_dead) {
  if (map.size() < limit) return;
  for (auto entry = map.begin(); entry != map.end();)
    entry = is_dead(entry->second) ? map.erase(entry) : std::next(entry);
  limit = std::max(kManyMeshes, 2 * map.size());
}

}  // namespace link_bounds
