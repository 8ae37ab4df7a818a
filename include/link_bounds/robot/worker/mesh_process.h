// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Mesh files are untrusted input: each is read by a process of its own, which is then gone.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

struct MeshLimits {
  double timeout = 30.0;                ///< wall seconds for one file, > 0
  std::uint64_t max_bytes = 536870912;  ///< of one file
};

/// Absolute path of the program mesh_worker: in the folder of the running program, else where it is
/// built or installed with this library. Throws std::system_error.
std::string meshWorker();

/// Starts `worker` (the program mesh_worker, by absolute path, without a shell) for this one file
/// and takes its answer. Whatever goes wrong in it, a crash, a hang, lack of memory, a wrong
/// answer, becomes a MeshError, and the process is gone in any case. While it runs, `is_cancelled`,
/// which may be null, is asked every 20 ms whether to give up. May be called from several threads.
TriangleMesh importInProcess(const std::string& worker, const MeshFile& file,
                             const MeshLimits& limits,
                             const std::function<bool()>& is_cancelled = nullptr);

}  // namespace link_bounds
