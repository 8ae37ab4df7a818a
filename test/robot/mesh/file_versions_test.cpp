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

/// In a file system without fractions of a second.
FileVersion changedSecondsAgo(long seconds) {
  FileVersion version = changedNow();
  version.changed = {version.changed.tv_sec - seconds, 0};
  return version;
}

/// Neither the missing file, which it may be at the next look, nor what it is now.
TEST(SettledVersion, OfAFileThatIsWrittenWithoutEndIsOfNoFile) {
  int asked = 0, ticks_left = 3;
  const FileVersion version = settledVersion(
      [&] {
        ++asked;
        return changedNow();
      },
      ticks_left);
  EXPECT_FALSE(version == FileVersion());
  EXPECT_EQ(version.inode, 0u);
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

TEST(SettledVersion, WaitsLongerWhereTimesAreWholeSeconds) {
  int ticks_left = 0;
  const auto later = [] { return changedSecondsAgo(1); };
  EXPECT_EQ(settledVersion(later, ticks_left).inode, 0u);
  const auto old = [] { return changedSecondsAgo(3); };
  EXPECT_EQ(settledVersion(old, ticks_left).inode, 2u);
}

TEST(SettledVersion, IsThatOfAnOldFileAlsoWhereNoTicksAreLeft) {
  int ticks_left = 0;
  EXPECT_TRUE(settledVersion([] { return kOld; }, ticks_left) == kOld);
}

}  // namespace
}  // namespace link_bounds
