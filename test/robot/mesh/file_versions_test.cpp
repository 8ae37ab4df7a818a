// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// When a file counts as no longer written, with times that no file system has to give.
#include "robot/mesh/file_versions.h"

#include <gtest/gtest.h>
#include <time.h>

namespace link_bounds {
namespace {

FileVersion changedNow() {
  FileVersion version{1, 2, 3, {}, {}};
  clock_gettime(CLOCK_REALTIME, &version.changed);
  return version;
}

constexpr FileVersion kOld{1, 2, 3, {4, 5}, {6, 7}};

TEST(SettledVersion, OfAFileThatIsWrittenWithoutEndThereIsNone) {
  int asked = 0, ticks_left = 3;
  const FileVersion version = settledVersion(
      [&] {
        ++asked;
        return changedNow();
      },
      ticks_left);
  EXPECT_TRUE(version == FileVersion());
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(ticks_left, 0);
}

TEST(SettledVersion, IsTheFirstThatIsOld) {
  int asked = 0, ticks_left = 3;
  const auto oldAtLast = [&] { return ++asked < 3 ? changedNow() : kOld; };
  EXPECT_TRUE(settledVersion(oldAtLast, ticks_left) == kOld);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(ticks_left, 1);
}

TEST(SettledVersion, IsThatOfAnOldFileAlsoWhereNoTicksAreLeft) {
  int ticks_left = 0;
  EXPECT_TRUE(settledVersion([] { return kOld; }, ticks_left) == kOld);
}

}  // namespace
}  // namespace link_bounds
