// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All benchmarks that measure within one process; scripts/bench --help says what each measures.
#include "bench/common/benchmarks.h"
#include "bench/common/driver.h"

int main(int argc, char** argv) {
  using namespace link_bounds::bench;
  return driveBenchmarks(argc, argv,
                         {
                             {"cloud", benchmarkClouds},
                             {"core", benchmarkCore, benchmarkCoreCold},
                             {"distances", benchmarkDistances},
                             {"objects", benchmarkObjects},
                             {"overlaps", benchmarkOverlaps},
                             {"parts", benchmarkParts},
                             {"pipeline", benchmarkPipeline, benchmarkPipelineCold},
                             {"stopping", benchmarkStopping},
                             {"swept", benchmarkSwept},
                             {"volumes", benchmarkVolumes},
#ifdef LINK_BOUNDS_WITH_CALLGRIND
                             {"cold-updates", runColdUpdates},
#endif
                         });
}
