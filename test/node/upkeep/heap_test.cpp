// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// When the memory of objects is worth returning; that it returns is shown by objects_alone.
#include "node/upkeep/heap.h"

#include <gtest/gtest.h>

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

TEST(ObjectMemory, OfFewObjectsIsNot) {
  ObjectMemory memory;
  EXPECT_FALSE(memory.isWorthReturning(999));
  EXPECT_FALSE(memory.isWorthReturning(0));
}

}  // namespace
}  // namespace link_bounds
