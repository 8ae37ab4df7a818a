// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes of objects: requested on the update thread, loaded on the loader thread.
#pragma once

#include <ros/callback_queue_interface.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "link_bounds/robot/mesh/mesh_store.h"

namespace link_bounds {

class MeshRequests {
 public:
  /// One result per URI, in order.
  using Load = std::function<std::vector<LoadedMesh>(const std::vector<std::string>& uris)>;
  using Handler = std::function<void(const std::string& uri, const LoadedMesh& mesh)>;

  /// `load` runs on the thread that serves `loader_queue`, `on_mesh` on the update thread. Both
  /// queues must not be served any more when this is destroyed.
  MeshRequests(ros::CallbackQueueInterface& loader_queue, ros::CallbackQueueInterface& update_queue,
               Load load, Handler on_mesh);
  MeshRequests(const MeshRequests&) = delete;
  MeshRequests& operator=(const MeshRequests&) = delete;

  /// Returns at once.
  void add(const std::string& uri);

 private:
  void loadAll();
  std::vector<std::string> takeAll();

  ros::CallbackQueueInterface& loader_queue_;
  ros::CallbackQueueInterface& update_queue_;
  Load load_;
  Handler on_mesh_;
  std::mutex mutex_;
  std::vector<std::string> uris_;  ///< guarded by mutex_
};

}  // namespace link_bounds
