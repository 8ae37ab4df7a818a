// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Eigen gives our code the same bits, whatever processor the user compiles it for.
#include "geometry/box/eigen_bits.h"

#include <gtest/gtest.h>

#include "testing/brute_force.h"

namespace link_bounds {
namespace {

bool isHaswell() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

TEST(EigenBits, AreTheSameWithMarchHaswell) {
  if (!isHaswell()) GTEST_SKIP() << "skipped: this processor does not run code for haswell";
  brute_force::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SixteenNumbers a, b;
    for (double& number : a)
      number = random.uniform(-1, 1);
    for (double& number : b)
      number = random.uniform(-1, 1);
    const EigenBits bits = eigenBits(a, b), haswell = haswellBits(a, b);
    ASSERT_EQ(bits.matrix, haswell.matrix);
    ASSERT_EQ(bits.pose, haswell.pose);
    ASSERT_EQ(bits.vector, haswell.vector);
  }
}

}  // namespace
}  // namespace link_bounds
