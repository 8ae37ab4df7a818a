// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads models on the loader thread, and meshes of objects on reader threads.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "node/interface/read_parameters.h"
#include "node/loading/mesh_readers.h"
#include "node/loading/robot_loading.h"
#include "world/bodies/object_source.h"
#include "world/model/model.h"

namespace link_bounds {

/// Everything that may take long or fail runs on these threads. The update thread adopts a finished
/// model. While there is no usable robot_description but fixed_frame is set, the model has no
/// robot.
class ModelLoader {
 public:
  using ModelPtr = std::shared_ptr<const Model>;

  /// The triangles of a mesh file whose points are in use.
  struct TreeRequest {
    std::string uri;
    std::weak_ptr<const PointSet> points;  ///< once they are freed, nobody needs the triangles
  };

  struct Handlers {
    std::function<void(ModelPtr)> adopt;  ///< see RobotLoading::Handlers::adopt
    /// Called on the update thread.
    std::function<void(const MeshRequest& request, const LoadedMesh& mesh)> on_mesh;
    /// Called on a reader thread.
    std::function<void(const TreeRequest& request, const LoadedTree& tree)> on_tree;
  };

  /// The update thread serves `update_queue`. Throws std::runtime_error if a thread cannot be
  /// started.
  ModelLoader(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
              ros::CallbackQueueInterface& update_queue, Handlers handlers);
  ModelLoader(const ModelLoader&) = delete;
  ModelLoader& operator=(const ModelLoader&) = delete;

  /// If nobody needs the mesh any more, loading ends without a result. requestMesh(), requestTree()
  /// and request() return at once and may be called on any thread. Before the first model nothing
  /// is loaded; the scene requests all meshes again when it adopts that model.
  void requestMesh(const MeshRequest& request);
  void requestTree(const TreeRequest& request);
  void request(const std::string& key, MeshReaders::Job job) { readers_.post(key, std::move(job)); }

  /// Like RobotLoader::loadTrees(), on the calling thread. Empty before the first model.
  std::vector<LoadedTree> loadTrees(const std::vector<std::string>& uris,
                                    const MeshReaders::IsCancelled& is_cancelled);

  /// Package paths and limits for the meshes of objects, by the parameters in use. nullopt before
  /// the first model.
  std::optional<MeshSource> source(const MeshReaders::IsCancelled& is_cancelled);

  bool waitsForDescription() const { return loading_.waitsForDescription(); }
  std::string descriptionName() const { return loading_.descriptionName(); }

  /// True if the first load failed permanently; the node is then shutting down.
  bool hasFailed() const { return loading_.hasFailed(); }

 private:
  using Loading = RobotLoading<Model, Parameters>;

  Loading::Handlers loadingHandlers();
  Loading::Loaded load(const std::string& urdf, const Parameters& parameters,
                       const std::function<bool()>& is_stopping);
  void adopt(const ModelPtr& model);
  ObjectSource::Points unchangedMeshes();
  void forgetPackages();
  std::uint64_t fileBytes(const std::string& uri);

  ros::CallbackQueueInterface& update_queue_;
  Handlers handlers_;
  RobotLoader robot_loader_;
  std::mutex mutex_;
  std::optional<MeshLimits> limits_;             ///< guarded by mutex_
  ObjectSource::Points object_meshes_;           ///< guarded by mutex_; the meshes that were loaded
  std::size_t max_object_meshes_ = kManyMeshes;  ///< guarded by mutex_
  PackagePath packages_;                         ///< guarded by mutex_
  std::chrono::steady_clock::time_point packages_since_;  ///< guarded by mutex_
  MeshReaders readers_;  ///< readers_ and loading_ last: their threads use the other members
  Loading loading_;
};

}  // namespace link_bounds
