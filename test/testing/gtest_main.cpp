// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs the tests of one executable; not every catkin links gtest's own main.
#include <gtest/gtest.h>

/// Tells ctest that all was well, but not everything could run; see gtest.cmake.
constexpr int kSkipped = 4;

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  const bool has_skipped = testing::UnitTest::GetInstance()->skipped_test_count() > 0;
  return result == 0 && has_skipped ? kSkipped : result;
}
