// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loader thread: waits for the robot description, loads models, answers ~reload.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "node/loading/mesh_requests.h"
#include "node/loading/model.h"
#include "node/loading/model_hand_over.h"
#include "node/loading/robot_description.h"
#include "node/parameters/parameter_server.h"

namespace link_bounds {

/// All that may take long or fail runs on this thread. The update thread, which serves the global
/// callback queue, adopts a finished model. While there is no usable description but a fixed frame
/// is set, the model has no robot.
class ModelLoader {
 public:
  using ModelPtr = ModelHandOver::ModelPtr;

  /// `adopt` and `on_mesh` run on the update thread. What `adopt` throws becomes the answer of
  /// ~reload, and `adopt` is called again with the old model. Throws std::runtime_error if the
  /// thread cannot be started.
  ModelLoader(ros::NodeHandle& private_node, std::function<void(ModelPtr)> adopt,
              MeshRequests::Handler on_mesh);
  ~ModelLoader();
  ModelLoader(const ModelLoader&) = delete;
  ModelLoader& operator=(const ModelLoader&) = delete;

  /// Returns at once; the mesh of an object is loaded when the thread is free.
  void requestMesh(const std::string& uri) { mesh_requests_.add(uri); }

  bool waitsForDescription() const { return waits_for_description_; }
  std::string descriptionName() const { return description_.name(); }

  /// True if the first load failed for good; the node is then shutting down.
  bool hasFailed() const { return has_failed_; }

 private:
  void run();
  void firstLoad();
  ModelPtr load(XmlRpc::XmlRpcValue description);
  std::vector<std::string> reload();
  void serveObjectsMeanwhile();
  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool handOver(ModelPtr model);
  bool isStopping() const;

  ModelHandOver hand_over_;
  ParameterServer server_;
  RobotDescription description_;
  RobotLoader robot_loader_;
  Parameters parameters_;
  bool has_loaded_ = false;      ///< a robot
  bool serves_objects_ = false;  ///< without a robot
  XmlRpc::XmlRpcValue refused_;  ///< a description that cannot be used, while objects are served
  std::atomic<bool> waits_for_description_{false};
  std::atomic<bool> has_failed_{false};
  std::atomic<bool> stops_{false};
  ros::CallbackQueue queue_;
  MeshRequests mesh_requests_;
  ros::ServiceServer reload_service_;
  std::thread thread_;
};

}  // namespace link_bounds
