// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The loader thread: waits for the robot description, loads models, answers ~reload. Beside it,
// readers load the meshes of objects.
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "node/interface/parameter_server.h"
#include "node/loading/mesh_readers.h"
#include "node/loading/model_hand_over.h"
#include "node/loading/robot_description.h"
#include "node/threads/worker.h"
#include "world/model/model.h"

namespace link_bounds {

/// All that may take long or fail runs on these threads. The update thread adopts a finished model.
/// While there is no usable description but a fixed frame is set, the model has no robot.
class ModelLoader {
 public:
  using ModelPtr = ModelHandOver::ModelPtr;

  /// The triangles of a mesh file whose points are in use.
  struct TreeRequest {
    std::string uri;
    std::weak_ptr<const PointSet> points;  ///< once they are gone, nobody waits for the triangles
  };

  struct Handlers {
    /// On the update thread. What it throws becomes the answer of ~reload, and it is called again
    /// with the old model.
    std::function<void(ModelPtr)> adopt;
    /// On the update thread.
    std::function<void(const std::string& uri, const LoadedMesh& mesh)> on_mesh;
    /// On a reader.
    std::function<void(const TreeRequest& request, const LoadedTree& tree)> on_tree;
  };

  /// The update thread serves `update_queue`. Throws std::runtime_error if a thread cannot be
  /// started.
  ModelLoader(ros::NodeHandle& private_node, ros::CallbackQueueInterface& update_queue,
              Handlers handlers);
  ~ModelLoader();
  ModelLoader(const ModelLoader&) = delete;
  ModelLoader& operator=(const ModelLoader&) = delete;

  /// The mesh of objects, as long as somebody has the URI: else loading it ends without an answer.
  /// This and the next two return at once and may be called on any thread.
  /// Before the first model nothing is loaded: to adopt a model is to request all meshes again.
  void requestMesh(const std::shared_ptr<const std::string>& uri);
  void requestTree(const TreeRequest& request);
  void request(const std::string& key, MeshReaders::Job job) { readers_.post(key, std::move(job)); }

  /// As RobotLoader::loadTrees(), on the thread that calls; nothing before the first model.
  std::vector<LoadedTree> loadTrees(const std::vector<std::string>& uris,
                                    const MeshReaders::IsCancelled& is_cancelled);

  /// Where meshes of objects are found, and what one may take, by the parameters in use. Nothing
  /// before the first model.
  std::optional<MeshSource> source(const MeshReaders::IsCancelled& is_cancelled);

  bool waitsForDescription() const { return waits_for_description_; }
  std::string descriptionName() const { return description_.name(); }

  /// True if the first load failed for good; the node is then shutting down.
  bool hasFailed() const { return has_failed_; }

 private:
  bool onTick();
  void firstLoad();
  ModelPtr load(XmlRpc::XmlRpcValue description);
  std::vector<std::string> reload();
  void serveObjectsMeanwhile();
  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  void adopt(const ModelPtr& model);
  std::uint64_t fileBytes(const std::string& uri);

  ros::CallbackQueueInterface& update_queue_;
  Handlers handlers_;
  ParameterServer server_;
  RobotDescription description_;
  RobotLoader robot_loader_;
  std::mutex mutex_;
  std::optional<MeshLimits> limits_;                      ///< guarded by mutex_
  PackagePath packages_;                                  ///< guarded by mutex_
  std::chrono::steady_clock::time_point packages_since_;  ///< guarded by mutex_
  Parameters parameters_;
  bool has_parameters_ = false;  ///< they were read
  bool has_loaded_ = false;      ///< a robot
  bool serves_objects_ = false;  ///< without a robot
  XmlRpc::XmlRpcValue refused_;  ///< a description that cannot be used, while objects are served
  std::atomic<bool> waits_for_description_{false};
  std::atomic<bool> has_failed_{false};
  MeshReaders readers_;
  ModelHandOver hand_over_{worker_, update_queue_, [this](const ModelPtr& model) { adopt(model); }};
  Worker worker_;  ///< after all that its thread uses
  ros::ServiceServer reload_service_;
};

}  // namespace link_bounds
