// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The public headers in a package whose compiler contracts products and sums to one rounding, as it
// does for ARM, and for x86 from -march=haswell on. This file is compiled with -ffp-contract=fast
// and optimised, without which nothing is contracted.
#include <gtest/gtest.h>

#include "link_bounds/geometry/box/rounding.h"
#include "testing/brute_force.h"
#include "testing/quad.h"

#if defined(__x86_64__) || defined(__i386__)
#define LINK_BOUNDS_CONTRACTED __attribute__((noinline, target("fma")))
#else
#define LINK_BOUNDS_CONTRACTED __attribute__((noinline))
#endif

namespace link_bounds {
namespace {

constexpr int kSums = 2'000'000;

bool canContract() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

LINK_BOUNDS_CONTRACTED double contracted(double x, double y, double b) {
  return x * y + b;
}

LINK_BOUNDS_CONTRACTED double productUp(double x, double y, double b) {
  return addUp(x * y, b);
}

LINK_BOUNDS_CONTRACTED double productDown(double x, double y, double b) {
  return addDown(x * y, b);
}

TEST(Contraction, DirectedSumsOfProductsStayOnTheirSide) {
  if (!canContract()) GTEST_SKIP() << "skipped: this processor has no fused multiply-add";
  brute_force::Random random(1);
  int fused = 0;
  int below = 0;
  int above = 0;
  for (int i = 0; i < kSums; ++i) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    const volatile double product = x * y;
    const volatile double sum = product + b;
    const Quad exact = static_cast<Quad>(product) + static_cast<Quad>(b);
    fused += contracted(x, y, b) != sum ? 1 : 0;
    below += static_cast<Quad>(productUp(x, y, b)) < exact ? 1 : 0;
    above += static_cast<Quad>(productDown(x, y, b)) > exact ? 1 : 0;
  }
  EXPECT_GT(fused, 0) << "the compiler contracts nothing, so this test shows nothing";
  EXPECT_EQ(below, 0) << "sums of " << kSums << " are below the real one";
  EXPECT_EQ(above, 0) << "sums of " << kSums << " are above the real one";
}

}  // namespace
}  // namespace link_bounds
