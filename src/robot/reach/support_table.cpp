// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Sorted by face, then by the axis after that of the face, then by the one after that.
#include "robot/reach/support_table.h"

namespace link_bounds {

std::vector<Eigen::Vector3d> SupportTable::directions(int cells) {
  std::vector<Eigen::Vector3d> result;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    Eigen::Vector3d direction;
    direction[axis] = face % 2 == 0 ? 1 : -1;
    for (int i = 0; i <= cells; ++i) {
      direction[(axis + 1) % 3] = 2.0 * i / cells - 1;
      for (int j = 0; j <= cells; ++j) {
        direction[(axis + 2) % 3] = 2.0 * j / cells - 1;
        result.push_back(direction);
      }
    }
  }
  return result;
}

}  // namespace link_bounds
