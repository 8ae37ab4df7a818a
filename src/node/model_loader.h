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
#include <string>
#include <thread>

#include "link_bounds/mesh_store.h"
#include "model.h"

namespace link_bounds {

/// Everything that may take long or fail happens here. A finished model is handed to the update
/// thread through the global callback queue; the old one comes back and is freed here too.
class ModelLoader {
 public:
  using ModelPtr = std::shared_ptr<const Model>;

  /// `adopt` runs on the update thread; it takes the new model and returns the old one.
  ModelLoader(ros::NodeHandle& private_node, std::function<ModelPtr(ModelPtr)> adopt);
  ~ModelLoader();
  ModelLoader(const ModelLoader&) = delete;
  ModelLoader& operator=(const ModelLoader&) = delete;

  bool waitsForDescription() const { return waits_for_description_; }

  /// True if the first load failed for good; the node is then shutting down.
  bool hasFailed() const { return has_failed_; }

 private:
  void run();
  void firstLoad();
  void load();
  TriangleMesh import(const MeshFile& file) const;
  bool onReload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  void sayWaiting();
  bool handOver(ModelPtr model);

  std::function<ModelPtr(ModelPtr)> adopt_;
  std::string worker_;
  MeshStore store_;
  Parameters parameters_;
  bool has_loaded_ = false;
  ros::WallTime last_said_;
  std::atomic<bool> waits_for_description_{false};
  std::atomic<bool> has_failed_{false};
  std::atomic<bool> stops_{false};
  ros::CallbackQueue queue_;
  ros::ServiceServer reload_service_;
  std::thread thread_;
};

}  // namespace link_bounds
