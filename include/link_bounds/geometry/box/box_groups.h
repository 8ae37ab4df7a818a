// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The state of each box at one moment, and the boxes of groups. Nothing here throws.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// The state of one named box.
struct BoxState {
  std::optional<Aabb> box;  ///< in the fixed frame; absent if unknown
  std::int64_t stamp = 0;   ///< nanoseconds; time of the transform used, 0 if all are static
  bool incomplete = true;   ///< missing, or known not to cover everything
};

/// True if both boxes are absent, or both are present and equal. Equal states agree in all fields.
bool isSame(const std::optional<Aabb>& a, const std::optional<Aabb>& b);
bool isSame(const BoxState& a, const BoxState& b);

/// A named set of boxes, given by their positions in the list of states.
struct BoxGroup {
  std::string name;
  std::vector<std::size_t> members;
  bool lacks_members = false;  ///< the user named a member that does not exist
};

/// Extends the state of a group by that of one more member.
void addMember(BoxState& group, const BoxState& member);

/// The union of the members that have a box; the oldest non-zero stamp of these; incomplete while
/// any member is missing or incomplete.
BoxState groupState(const BoxGroup& group, const std::vector<BoxState>& states);

}  // namespace link_bounds
