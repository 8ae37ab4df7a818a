// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a process that reads untrusted meshes forbids itself before it opens the first one.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace link_bounds {

/// Bytes of memory that a reader may take for a file of that size: readers keep text and numbers
/// side by side, up to some twenty times the file.
std::uint64_t memoryLimit(std::uint64_t file_bytes);

struct MemoryLimits {
  std::uint64_t now;  ///< bytes, until raiseMemoryLimit()
  std::uint64_t max;  ///< bytes, for ever
};

/// For the rest of this process's life: no memory above the limits (but under sanitizers, which
/// take terabytes of addresses), no more time of the processor than that, few files at once, none
/// written, no further process or thread (root may start some), no core file, no new privileges, no
/// descriptor but the standard streams. It is killed when `parent` ends, and at once if that has
/// happened. Throws std::system_error if the kernel refuses one of the limits.
void limitThisProcess(const MemoryLimits& memory, long cpu_seconds, pid_t parent);

/// So much memory, if it is more than now, but never more than the max. Throws std::system_error.
void raiseMemoryLimit(std::uint64_t bytes);

}  // namespace link_bounds
