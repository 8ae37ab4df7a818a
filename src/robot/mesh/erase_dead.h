// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// For maps of meshes, whose names others may invent without end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace link_bounds {

/// How many entries a map may have before somebody looks which of them are dead.
constexpr std::size_t kManyMeshes = 10000;

/// Once the map has `limit` entries, erases those whose value `is_dead`. The limit becomes twice
/// what is left, kManyMeshes at least; so an insertion pays for a few looks at most.
template <class Map, class IsDead>
void eraseDead(Map& map, std::size_t& limit, const IsDead& is_dead) {
  if (map.size() < limit) return;
  for (auto entry = map.begin(); entry != map.end();)
    entry = is_dead(entry->second) ? map.erase(entry) : std::next(entry);
  limit = std::max(kManyMeshes, 2 * map.size());
}

}  // namespace link_bounds
