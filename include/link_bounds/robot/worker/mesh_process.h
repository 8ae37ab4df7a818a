// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Mesh files are untrusted input, so each is read by a process of its own.
#pragma once

#include <functional>
#include <string>

#include "link_bounds/robot/mesh/imported_mesh.h"
#include "link_bounds/robot/mesh/mesh_limits.h"
#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

/// Absolute path of the program mesh_worker. It is looked for in the folder of the running program,
/// then where it is built or installed with this library. Throws std::system_error.
std::string meshWorker();

/// Starts `worker`, the absolute path of mesh_worker, for one file and returns what it reads. A
/// crash, a timeout, lack of memory or a malformed reply becomes a MeshError. The process has ended
/// when this returns, unless the kernel cannot kill it. While it runs, `is_cancelled`, which may be
/// null, is called at least every 20 ms. Several threads may call this.
TriangleMesh importInProcess(const std::string& worker, const MeshFile& file,
                             const MeshLimits& limits,
                             const std::function<bool()>& is_cancelled = nullptr);

/// The same for a deadline that has begun before. It is called at least every 20 ms. Also returns
/// which files mesh_worker opened or looked for, by absolute path.
ImportedMesh importInTime(const std::string& worker, const MeshFile& file, const MeshLimits& limits,
                          const CheckInterrupt& deadline);

}  // namespace link_bounds
