// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The queries in NEON.
#ifdef __aarch64__
#include "geometry/support/query/double4_neon.h"
// Needs the Double4 above.
#include "geometry/support/query/kernels.h"

namespace link_bounds {

const Query kNeonQuery{QueryPath::kNeon, find, scan, scanAll};

}  // namespace link_bounds
#endif
