// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Unions of boxes.
#include "link_bounds/geometry/box/box_groups.h"

namespace link_bounds {

bool isSame(const std::optional<Aabb>& a, const std::optional<Aabb>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->min() == b->min() && a->max() == b->max();
}

bool isSame(const BoxState& a, const BoxState& b) {
  return a.stamp == b.stamp && a.incomplete == b.incomplete && isSame(a.box, b.box);
}

void addMember(BoxState& group, const BoxState& member) {
  group.incomplete |= member.incomplete;
  if (!member.box) return;
  group.box = group.box ? group.box->merged(*member.box) : *member.box;
  if (member.stamp != 0 && (group.stamp == 0 || member.stamp < group.stamp)) {
    group.stamp = member.stamp;
  }
}

BoxState groupState(const BoxGroup& group, const std::vector<BoxState>& states) {
  BoxState result;
  result.incomplete = group.lacks_members;
  for (const std::size_t member : group.members)
    addMember(result, states[member]);
  return result;
}

}  // namespace link_bounds
