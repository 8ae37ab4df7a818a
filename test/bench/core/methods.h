// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All ways to compute boxes; each file that is named after some of them adds those.
#pragma once

#include <string>

#include "bench/core/method.h"
#include "geometry/support/query/direction_query.h"

namespace link_bounds::bench {

void addScans(const Trial& trial, Suite& suite);
void addOurs(const Trial& trial, Suite& suite);
void addLooseBoxes(const Trial& trial, Suite& suite);
void addBullet(const Trial& trial, Suite& suite);
void addFcl(const Trial& trial, Suite& suite);
void addGeometricShapes(const Trial& trial, Suite& suite);

/// The cost per link of updates of few and many links.
void addLinkCounts(const MeasuredMeshes& meshes, Suite& suite);

/// ours_plain, ours_sse2 or ours_avx2.
std::string nameOfOurs(QueryPath path);

}  // namespace link_bounds::bench
