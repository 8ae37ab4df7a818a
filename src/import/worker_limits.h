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

/// For the rest of this process's life: no memory above the limit (but under sanitizers, which take
/// terabytes of addresses), no more time of the processor than that, few files at once, none
/// written, no further process or thread (root may start some), no core file, no new privileges, no
/// descriptor but the standard streams. It is killed when `parent` ends, and at once if that has
/// happened. Throws std::system_error if the kernel refuses one of the limits.
void limitThisProcess(std::uint64_t memory_bytes, long cpu_seconds, pid_t parent);

}  // namespace link_bounds
