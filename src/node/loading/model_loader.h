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

#include "node/loading/load_requests.h"
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

  /// The triangles of a mesh file whose points are in use.
  struct TreeRequest {
    std::string uri;
    std::shared_ptr<const PointSet> points;
  };

  struct Handlers {
    /// On the update thread. What it throws becomes the answer of ~reload, and it is called again
    /// with the old model.
    std::function<void(ModelPtr)> adopt;
    /// On the update thread.
    std::function<void(const std::string& uri, const LoadedMesh& mesh)> on_mesh;
    /// On the loader thread.
    std::function<void(const TreeRequest& request, const LoadedTree& tree)> on_tree;
  };

  /// Throws std::runtime_error if the thread cannot be started.
  ModelLoader(ros::NodeHandle& private_node, Handlers handlers);
  ~ModelLoader();
  ModelLoader(const ModelLoader&) = delete;
  ModelLoader& operator=(const ModelLoader&) = delete;

  /// The mesh of an object. This and the next two return at once and may be called on any thread;
  /// the work is done when the loader thread is free.
  void requestMesh(const std::string& uri) { mesh_requests_.add(uri); }
  void requestTree(TreeRequest request) { tree_requests_.add(std::move(request)); }
  void request(std::function<void()> work) { enqueue(queue_, std::move(work)); }

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
  std::vector<LoadedTree> loadTrees(const std::vector<TreeRequest>& requests);
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
  LoadRequests<std::string, LoadedMesh> mesh_requests_;
  LoadRequests<TreeRequest, LoadedTree> tree_requests_;
  ros::ServiceServer reload_service_;
  std::thread thread_;
};

}  // namespace link_bounds
