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

#include "node/loading/model.h"
#include "node/loading/model_hand_over.h"
#include "node/parameters/parameter_server.h"

namespace link_bounds {

/// Everything that may take long or fail happens here. A finished model is handed to the update
/// thread through the global callback queue; the old one is freed here, too. While there is no
/// description that can be used but a fixed frame is set, the model is one without a robot.
class ModelLoader {
 public:
  using ModelPtr = ModelHandOver::ModelPtr;

  /// What becomes of a mesh that was requested; on the update thread, too.
  using MeshHandler = std::function<void(const std::string& uri, const LoadedMesh& mesh)>;

  /// `adopt` runs on the update thread and takes the new model; what it throws is what ~reload
  /// answers, and it is called again with the old model. Throws std::runtime_error if there can be
  /// no thread.
  ModelLoader(ros::NodeHandle& private_node, std::function<void(ModelPtr)> adopt,
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
  void load(XmlRpc::XmlRpcValue description);
  void reload();
  void serveObjectsMeanwhile();
  void loadRequestedMeshes();
  XmlRpc::XmlRpcValue readDescription() const;
  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  void sayWaiting(const std::string& reason);
  bool handOver(ModelPtr model);
  bool isToEnd() const;

  ModelHandOver hand_over_;
  MeshHandler on_mesh_;
  ParameterServer server_;
  RobotLoader robot_loader_;
  Parameters parameters_;
  bool has_loaded_ = false;      ///< a robot
  bool serves_objects_ = false;  ///< though there is no robot
  XmlRpc::XmlRpcValue refused_;  ///< the description that cannot be used while objects are served
  ros::SteadyTime last_said_;
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
