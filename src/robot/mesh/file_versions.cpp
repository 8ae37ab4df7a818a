// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/mesh/file_versions.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

namespace link_bounds {
namespace {

/// Twice the longest tick of the kernel clock that sets the times of files (10 ms at 100 Hz). Two
/// writes within one tick give the same version.
constexpr std::chrono::milliseconds kFileTick(20);

/// File systems with whole seconds, such as ext3, have ticks of 1 s, FAT of 2 s.
constexpr std::chrono::milliseconds kCoarseTick(2020);

/// A missing file has size 0, so this is not its version either.
constexpr FileVersion kNeverSettled{0, 0, std::numeric_limits<std::uint64_t>::max(), {}, {}};

bool areEqual(const timespec& a, const timespec& b) {
  return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

/// The time since `time` in seconds, as a double, because a file may claim any time.
double secondsSince(const timespec& time) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<double>(now.tv_sec) - static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - time.tv_nsec);
}

bool isSettled(const FileVersion& version) {
  const double age = secondsSince(version.changed);
  const std::chrono::duration<double> tick = version.changed.tv_nsec == 0 ? kCoarseTick : kFileTick;
  return age < 0 || age > tick.count();
}

}  // namespace

bool FileVersion::operator==(const FileVersion& other) const {
  return device == other.device && inode == other.inode && size == other.size &&
         areEqual(written, other.written) && areEqual(changed, other.changed);
}

FileVersion fileVersion(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return {};
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), status.st_mtim,
          status.st_ctim};
}

FileVersion fileVersion(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? fileVersion(status) : FileVersion{};
}

FileVersion settledVersion(const std::function<FileVersion()>& version, int& ticks_left,
                           const std::function<bool()>& is_cancelled) {
  for (;; --ticks_left) {
    const FileVersion now = version();
    if (isSettled(now)) return now;
    if (ticks_left <= 0 || (is_cancelled && is_cancelled())) return kNeverSettled;
    std::this_thread::sleep_for(kFileTick);
  }
}

bool areUnchanged(const FileVersions& files) {
  return std::all_of(files.begin(), files.end(),
                     [](const auto& file) { return fileVersion(file.first) == file.second; });
}

}  // namespace link_bounds
