// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/upkeep/heap.h"

#include <malloc.h>

#include <algorithm>

namespace link_bounds {
namespace {

constexpr int kLargeBlock = 1 << 20;  // bytes; smaller blocks are frequent and reused faster
constexpr int kKeptAtEnd = 4 << 20;   // bytes; a scene copy for ~swept of 200 links takes 2 MiB
constexpr std::size_t kManyObjects = 1000;  // this many take about 1 MiB

}  // namespace

void returnLargeBlocks() {
  mallopt(M_MMAP_THRESHOLD, kLargeBlock);
  mallopt(M_TRIM_THRESHOLD, kKeptAtEnd);
}

bool ObjectMemory::isWorthReturning(std::size_t objects) {
  max_objects_ = std::max(max_objects_, objects);
  if (max_objects_ < kManyObjects || objects > max_objects_ / 2) return false;
  max_objects_ = objects;
  return true;
}

void returnFreeMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace link_bounds
