// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Returns freed memory to the system that the C library would keep.
#pragma once

#include <cstddef>

namespace link_bounds {

/// From now on, freed blocks of 1 MiB or more return to the system. By default the C library keeps
/// blocks up to the size of the largest one ever freed: the process had 67 MiB instead of 16 MiB
/// after tf messages of 300,000 transforms. Up to 4 MiB of free memory stay at the end of the heap.
void returnLargeBlocks();

/// Watches the number of objects. The C library keeps thousands of small blocks that are freed
/// between others: the process had 28 MiB instead of 16 MiB after 10,000 objects.
class ObjectMemory {
 public:
  /// True if there were 1,000 objects or more, and at least half of them are gone.
  bool isWorthReturning(std::size_t objects);

 private:
  std::size_t max_objects_ = 0;  ///< max since isWorthReturning() last returned true
};

/// Returns all free memory. Blocks the calling thread for about 1 ms after 10,000 objects.
void returnFreeMemory();

}  // namespace link_bounds
