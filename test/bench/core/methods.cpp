// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Peers that are not installed have no file in the build.
#include "bench/core/methods.h"

namespace link_bounds::bench {

void addMethods(const Trial& trial, Suite& suite) {
  addScans(trial, suite);
  addOurs(trial, suite);
  addLooseBoxes(trial, suite);
#ifdef LINK_BOUNDS_WITH_BULLET
  addBullet(trial, suite);
#endif
#ifdef LINK_BOUNDS_WITH_FCL
  addFcl(trial, suite);
#endif
#ifdef LINK_BOUNDS_WITH_GEOMETRIC_SHAPES
  addGeometricShapes(trial, suite);
#endif
}

}  // namespace link_bounds::bench
