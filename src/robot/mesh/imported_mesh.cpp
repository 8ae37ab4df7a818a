// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "link_bounds/robot/mesh/imported_mesh.h"

#include <algorithm>

namespace link_bounds {
namespace {

bool areEqual(const timespec& a, const timespec& b) {
  return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

/// In seconds; as double, because a file may claim any time.
double secondsSince(const timespec& time) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<double>(now.tv_sec) - static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - time.tv_nsec);
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

bool isSettled(const FileVersion& version) {
  const double age = secondsSince(version.changed);
  return age < 0 || age > std::chrono::duration<double>(kFileTick).count();
}

bool areUnchanged(const FileVersions& files) {
  return std::all_of(files.begin(), files.end(),
                     [](const auto& file) { return fileVersion(file.first) == file.second; });
}

}  // namespace link_bounds
