// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Unions of boxes.
#include "link_bounds/box_groups.h"

namespace link_bounds {

BoxState groupState(const BoxGroup& group, const std::vector<BoxState>& states) {
  BoxState result;
  result.incomplete = group.lacks_members;
  for (const std::size_t member : group.members) {
    const BoxState& state = states[member];
    result.incomplete |= state.incomplete;
    if (!state.box) continue;
    result.box = result.box ? result.box->merged(*state.box) : *state.box;
    if (state.stamp != 0 && (result.stamp == 0 || state.stamp < result.stamp)) {
      result.stamp = state.stamp;
    }
  }
  return result;
}

}  // namespace link_bounds
