// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The node: subscriptions, and the state of the update thread.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>

#include "node/clock/clock_watch.h"
#include "node/diagnostics/diagnostics.h"
#include "node/loading/model_loader.h"
#include "node/log/refusal_log.h"
#include "node/master/master_watch.h"
#include "node/names/topics.h"
#include "node/objects/object_source.h"
#include "node/outputs/scene_output.h"
#include "node/scene/scene.h"
#include "node/tf/transform_source.h"

namespace link_bounds {

/// Everything here runs on the thread that spins the global callback queue.
class PublisherNode {
 public:
  PublisherNode();

  /// 0, or 1 if there was nothing to publish.
  int exitCode() const { return loader_->hasFailed() ? 1 : 0; }

 private:
  using TfEvent = ros::MessageEvent<const TfMessage>;
  /// Not const: as the only reader of the topic the node may take points out of the message.
  using MarkersEvent = ros::MessageEvent<visualization_msgs::MarkerArray>;
  using MarkerEvent = ros::MessageEvent<visualization_msgs::Marker>;

  void subscribe();
  ros::Subscriber subscribeToTf(const TopicName& topic, bool is_static);
  void subscribeToObjects();
  void adopt(ModelLoader::ModelPtr model);
  void onTransforms(const TfEvent& event, bool is_static);
  void addTransforms(const std::vector<TransformView>& transforms, bool is_static, ros::Time now,
                     const TfEvent& event);
  void onMarkers(const MarkersEvent& event);
  void onMarker(const MarkerEvent& event);
  void onMesh(const std::string& uri, const LoadedMesh& mesh);
  void onTick();
  void observeClock(ros::Time now);
  void watchMemory();
  void onNews();
  void publishDiagnostics();

  /// Guards a callback and takes its time [ms], which it returns.
  template <class Body>
  double timed(Body&& body);

  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  TfMessageMemory tf_memory_;
  TfMessageMemory tf_static_memory_;
  TransformSource tf_;
  Scene scene_;
  ObjectSource object_source_;
  std::size_t most_objects_ = 0;  ///< since memory was given back
  ModelLoader::ModelPtr model_;
  ClockWatch clock_;
  RefusalLog refusal_log_{"a transform of", "transforms of further frames"};
  Health health_;
  ros::SteadyTime last_status_ = ros::SteadyTime::now();
  std::uint64_t last_updates_ = 0;  ///< as of last_status_
  SceneOutput output_;
  ros::Publisher diagnostics_publisher_;
  ros::Subscriber tf_subscriber_;
  ros::Subscriber tf_static_subscriber_;
  ros::Subscriber objects_subscriber_;
  ros::Subscriber object_subscriber_;
  ros::WallTimer tick_timer_;
  ros::WallTimer diagnostics_timer_;
  std::unique_ptr<ModelLoader> loader_;  ///< near the end: its thread ends before the rest goes
  std::unique_ptr<MasterWatch> master_watch_;
};

}  // namespace link_bounds
