// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The queries in SSE2.
#ifdef __SSE2__
#include "geometry/support/query/double4_sse2.h"
// Needs the Double4 above.
#include "geometry/support/query/kernels.h"

namespace link_bounds {

const Query kSse2Query{QueryPath::kSse2, find, scan, scanAll};

}  // namespace link_bounds
#endif
