// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of a path where there is neither SSE2 nor AVX2 nor NEON; direction_query.cpp is
// compiled into this test as on such a processor.
#include <gtest/gtest.h>

#include "geometry/support/query/direction_query.h"

namespace link_bounds {
namespace {

TEST(PlainPath, IsTheOnlyOneOfAnotherProcessor) {
  EXPECT_TRUE(isSupported(QueryPath::kPlain));
  EXPECT_FALSE(isSupported(QueryPath::kSse2));
  EXPECT_FALSE(isSupported(QueryPath::kAvx2));
  EXPECT_FALSE(isSupported(QueryPath::kNeon));
  EXPECT_EQ(queryPath(), QueryPath::kPlain);
  useQueryPath(QueryPath::kPlain);
  EXPECT_EQ(queryPath(), QueryPath::kPlain);
}

}  // namespace
}  // namespace link_bounds
