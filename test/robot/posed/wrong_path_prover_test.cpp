// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// An engine whose bodies move by 0.9 of what they do misses contacts: the test that finds all of
// them would see it.
#include <gtest/gtest.h>

#include "testing/thin_plates.h"

namespace link_bounds {
namespace {

TEST(WrongPathProver, MissesContactsBetweenSamples) {
  const PlateCounts counts = crossedPlates(300);
  EXPECT_LT(counts.found, 300);
}

}  // namespace
}  // namespace link_bounds
