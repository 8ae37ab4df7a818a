// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads that load the meshes of objects and make their trees of triangles. ~reload does not wait
// for them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "node/threads/worker.h"

namespace link_bounds {

/// One to four threads for small meshes, as many as cores, and one for all large ones, so that a
/// small mesh never waits for a large one.
class MeshReaders {
 public:
  /// True if the result is no longer needed: a newer job has the same key, or the node is shutting
  /// down.
  using IsCancelled = std::function<bool()>;

  struct Job {
    std::function<std::uint64_t()> bytes;  ///< size of the file or list; called on a reader thread
    /// The work must ask `is_cancelled` often, and once more before it gives its result. While it
    /// waits in the queue it must hold no reference to the mesh.
    std::function<void(const IsCancelled& is_cancelled)> work;
  };

  /// Throws std::runtime_error if a thread cannot be started.
  MeshReaders();

  /// Returns at once. A new job replaces the job of the same key, also one that is running. Any
  /// thread may call post() and stop().
  void post(const std::string& key, Job job);

  /// Ends the threads. Waiting jobs are dropped.
  void stop();

 private:
  Worker large_;
  std::vector<std::unique_ptr<Worker>> small_;  ///< a key always goes to the same thread; declared
                                                ///< last because their work uses large_
};

}  // namespace link_bounds
