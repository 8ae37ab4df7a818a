// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The limits that mesh_worker sets itself before it opens an untrusted file.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace link_bounds {

/// Bytes of memory that a reader may use for a file of that size: 512 MiB, and 32 times the file.
/// Readers were seen to use twenty times the file, because they hold its text and its numbers at
/// the same time.
std::uint64_t memoryLimit(std::uint64_t file_bytes);

struct MemoryLimits {
  std::uint64_t now;  ///< bytes
  std::uint64_t max;  ///< bytes; raiseMemoryLimit() cannot exceed it
};

/// For the rest of the life of this process:
/// - no memory above the limits (not under sanitizers, which reserve terabytes of addresses);
/// - at most `cpu_seconds` of processor time;
/// - at most 32 open files, and no writing to files;
/// - no further process or thread (root is exempt), no core file, no new privileges;
/// - no inherited descriptor but the standard streams.
/// The kernel kills it when `parent` ends; if `parent` has ended, it exits at once. Throws
/// std::system_error if the kernel refuses one of the limits.
void limitThisProcess(const MemoryLimits& memory, long cpu_seconds, pid_t parent);

/// Raises the limit of memory to `bytes`, at most to the max; never lowers it. Throws
/// std::system_error.
void raiseMemoryLimit(std::uint64_t bytes);

}  // namespace link_bounds
