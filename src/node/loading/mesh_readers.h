// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads that load the meshes of objects and make trees: ~reload waits for none of them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "node/threads/worker.h"

namespace link_bounds {

/// Several threads for small meshes, and one for all large ones: a small mesh waits for no large
/// one. Each request is answered as soon as it is ready.
class MeshReaders {
 public:
  /// True if nobody waits for the work any more: it has a successor, or the node ends.
  using IsCancelled = std::function<bool()>;

  struct Job {
    std::function<std::uint64_t()> bytes;  ///< of the file or list; called on a reader
    /// Calls `is_cancelled` often, also before it answers. Keeps no mesh alive while it waits.
    std::function<void(const IsCancelled& is_cancelled)> work;
  };

  /// Throws std::runtime_error if a thread cannot be started.
  MeshReaders();

  /// Both functions may be called on any thread. This one returns at once. A job replaces the one
  /// of its key, also while that runs.
  void post(const std::string& key, Job job);

  /// Ends the threads; what waits is not done.
  void stop();

 private:
  Worker large_;
  std::vector<std::unique_ptr<Worker>> small_;  ///< a key always goes to the same one; last: their
                                                ///< work uses large_
};

}  // namespace link_bounds
