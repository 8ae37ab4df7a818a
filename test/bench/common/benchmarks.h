// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of all benchmarks: benchmarkCore() is in core/core_bench.cpp.
#pragma once

#include "bench/common/row.h"

namespace link_bounds::bench {

Rows benchmarkClouds(bool quick);
Rows benchmarkCore(bool quick);
Rows benchmarkCoreCold(bool quick);
Rows benchmarkDistances(bool quick);
Rows benchmarkObjects(bool quick);
Rows benchmarkOverlaps(bool quick);
Rows benchmarkParts(bool quick);
Rows benchmarkPipeline(bool quick);
Rows benchmarkPipelineCold(bool quick);
Rows benchmarkStopping(bool quick);
Rows benchmarkSwept(bool quick);
Rows benchmarkVolumes(bool quick);

/// Updates that Callgrind counts, see pipeline_cold.py; no rows.
Rows runColdUpdates(bool quick);

}  // namespace link_bounds::bench
