// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Tells whether files have changed.
#pragma once

#include <sys/stat.h>

#include <functional>

#include "link_bounds/robot/mesh/imported_mesh.h"

namespace link_bounds {

constexpr char kChangedReason[] = "it changed while it was read";

FileVersion fileVersion(const struct stat& status);

/// Calls `version` until a tick of the clock of files has passed since the last write, so that
/// every later write gives another version. Returns a version that no file ever has if somebody
/// goes on writing until no ticks are left, or if `is_cancelled`, which may be null, returns true.
FileVersion settledVersion(const std::function<FileVersion()>& version, int& ticks_left,
                           const std::function<bool()>& is_cancelled = nullptr);

constexpr int kMaxFileTicks = 110;  ///< together 2.2 s, longer than any tick

/// True if all files still have these versions.
bool areUnchanged(const FileVersions& files);

}  // namespace link_bounds
