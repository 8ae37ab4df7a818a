// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The second thread of the node: waits for the robot description, loads models, answers ~reload.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "link_bounds/mesh_store.h"
#include "model.h"

namespace link_bounds {

/// Everything that may take long or fail happens here. A finished model is handed to the update
/// thread through the global callback queue; the old one comes back and is freed here too. While
/// there is no description but a fixed frame is set, the model is one without a robot.
class ModelLoader {
 public:
  using ModelPtr = std::shared_ptr<const Model>;

  /// What becomes of a mesh that was requested; on the update thread, too.
  using MeshHandler = std::function<void(const std::string& uri, const LoadedMesh& mesh)>;

  /// `adopt` runs on the update thread; it takes the new model and returns the old one.
  ModelLoader(ros::NodeHandle& private_node, std::function<ModelPtr(ModelPtr)> adopt,
              MeshHandler on_mesh);
  ~ModelLoader();
  ModelLoader(const ModelLoader&) = delete;
  ModelLoader& operator=(const ModelLoader&) = delete;

  /// Loads the mesh of an object when there is time; returns at once.
  void requestMesh(const std::string& uri);

  /// Gives back to the system what the C library keeps of freed memory, on this thread.
  void giveBackMemory();

  bool waitsForDescription() const { return waits_for_description_; }

  /// True if the first load failed for good; the node is then shutting down.
  bool hasFailed() const { return has_failed_; }

 private:
  void run();
  void firstLoad();
  void load();
  void serveObjectsMeanwhile();
  void loadRequestedMeshes();
  TriangleMesh import(const MeshFile& file) const;
  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  void sayWaiting();
  bool handOver(ModelPtr model);

  std::function<ModelPtr(ModelPtr)> adopt_;
  MeshHandler on_mesh_;
  std::string worker_;
  MeshStore store_;
  Parameters parameters_;
  bool has_loaded_ = false;      ///< a robot
  bool serves_objects_ = false;  ///< though there is no robot
  ros::WallTime last_said_;
  std::atomic<bool> waits_for_description_{false};
  std::atomic<bool> has_failed_{false};
  std::atomic<bool> stops_{false};
  std::mutex requests_mutex_;
  std::vector<std::string> requests_;  ///< URIs of meshes
  ros::CallbackQueue queue_;
  ros::ServiceServer reload_service_;
  std::thread thread_;
};

}  // namespace link_bounds
