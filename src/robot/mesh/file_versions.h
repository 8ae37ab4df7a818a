// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether files are still as they were.
#pragma once

#include <sys/stat.h>

#include <functional>

#include "link_bounds/robot/mesh/imported_mesh.h"

namespace link_bounds {

constexpr char kChangedReason[] = "it changed while it was read";

FileVersion fileVersion(const struct stat& status);

/// Asks `version` until a tick of the clock of files has passed since the last write, so that every
/// later write gives another version. Where somebody goes on writing until no ticks are left, or
/// when it `is_cancelled`, which may be null, the answer is all 0, as which no file is unchanged.
FileVersion settledVersion(const std::function<FileVersion()>& version, int& ticks_left,
                           const std::function<bool()>& is_cancelled = nullptr);

constexpr int kMaxFileTicks = 50;  ///< a second

/// True if all of them are as they were.
bool areUnchanged(const FileVersions& files);

}  // namespace link_bounds
