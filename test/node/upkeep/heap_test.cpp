// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the heap keeps, and when the memory of objects is worth returning; that it returns is shown
// by objects_alone.
#include "node/upkeep/heap.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

#include "testing/sanitized.h"

namespace link_bounds {
namespace {

TEST(ObjectMemory, IsWorthReturningOnceWhenHalfOfManyAreGone) {
  ObjectMemory memory;
  EXPECT_FALSE(memory.isWorthReturning(3000));
  EXPECT_FALSE(memory.isWorthReturning(1501));
  EXPECT_TRUE(memory.isWorthReturning(1500));
  EXPECT_FALSE(memory.isWorthReturning(1500));
  EXPECT_TRUE(memory.isWorthReturning(0));
  EXPECT_FALSE(memory.isWorthReturning(0));
}

/// A copy of the scene is as large, and is freed as often as it is made.
TEST(Heap, KeepsThreeMegabytesThatWereFreed) {
  if (kIsSanitized) GTEST_SKIP() << "skipped: a sanitizer has a heap of its own";
  returnLargeBlocks();
  const void* begin = sbrk(0);
  const void* end = nullptr;
  {
    const std::vector<std::vector<char>> blocks(30, std::vector<char>(100'000));
    end = sbrk(0);
  }
  EXPECT_GT(end, begin) << "the blocks were nowhere else";
  EXPECT_EQ(sbrk(0), end);
}

TEST(ObjectMemory, OfFewObjectsIsNot) {
  ObjectMemory memory;
  EXPECT_FALSE(memory.isWorthReturning(999));
  EXPECT_FALSE(memory.isWorthReturning(0));
}

}  // namespace
}  // namespace link_bounds
