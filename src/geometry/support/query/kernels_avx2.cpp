// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The queries in AVX2.
#ifdef __SSE2__
#include "geometry/support/query/double4_avx2.h"
// Needs the Double4 above.
#include "geometry/support/query/kernels.h"

namespace link_bounds {

const Query kAvx2Query{QueryPath::kAvx2, find, scan, scanAll};

}  // namespace link_bounds
#endif
