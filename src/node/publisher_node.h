// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The node: connects its inputs to the scene, and the scene to its outputs.
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>

#include "node/inputs/incomplete_messages.h"
#include "node/inputs/tf_receiver.h"
#include "node/interface/topics.h"
#include "node/loading/model_loader.h"
#include "node/master/master_watch.h"
#include "node/outputs/copies/scene_copier.h"
#include "node/outputs/earliest_output.h"
#include "node/outputs/scene_output.h"
#include "node/outputs/stopping_output.h"
#include "node/outputs/swept_output.h"
#include "node/services/box_service.h"
#include "node/services/path_service.h"
#include "node/threads/callback_times.h"
#include "node/threads/periodic.h"
#include "node/threads/timed_queue.h"
#include "node/upkeep/diagnostics.h"
#include "node/upkeep/heap.h"
#include "node/upkeep/lost_frames.h"
#include "world/bodies/scene_feed.h"

namespace link_bounds {

/// All functions run on the thread that calls spin(), the update thread, unless stated otherwise.
class PublisherNode {
 public:
  PublisherNode();
  ~PublisherNode();
  PublisherNode(const PublisherNode&) = delete;
  PublisherNode& operator=(const PublisherNode&) = delete;

  /// Handles callbacks until the node is shut down.
  void spin();

  /// 0, or 1 if the first load failed permanently.
  int exitCode() const { return loader_->hasFailed() ? 1 : 0; }

 private:
  using Marker = visualization_msgs::Marker;
  /// The event type of subscribeReceived(). It is not const, so that callbacks may move data out of
  /// a message.
  using NeighbourEvent = ros::MessageEvent<Received<AxisAlignedBoxArray>>;

  /// Updates the scene, then runs a callback that does not handle a message. Records its time.
  void measure(const std::function<void()>& body);

  /// Runs the callback of a message and records its time; lets no exception out.
  void guardMessage(const std::function<void()>& body);

  void callWaiting();

  void repeat(ros::WallDuration period, void (PublisherNode::*function)());
  TreeRequests treeRequests();
  void makeListTree(const std::shared_ptr<const ObjectContent>& list,
                    const MeshReaders::IsCancelled& is_cancelled);
  void onTree(const ModelLoader::TreeRequest& request, const LoadedTree& tree);
  void give(const MadeTree& tree);
  /// `take` gets each complete message and the name of its sender.
  template <class Message, class Take>
  ros::Subscriber subscribe(const TopicName& topic, std::uint32_t size, Take take);
  void subscribeToObjects();
  void adopt(ModelLoader::ModelPtr model);
  void onTransforms(const TfReceiver::Event& event, bool is_static);
  void onMarkers(Marker* markers, std::size_t count, const std::string& publisher);
  void onNeighbour(const NeighbourEvent& event);
  void onTick();
  void freeMemory();
  void onNews();
  void warnOfLostFrames();
  void publishDiagnostics();

  TimedQueue queue_;  ///< first, because the other members post into it
  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  SceneFeed feed_;
  Scene& scene_ = feed_.scene();
  ObjectMemory object_memory_;
  ModelLoader::ModelPtr model_;
  CallbackTimes times_;
  std::uint64_t updates_ = 0;
  std::size_t skipped_ = 0;                ///< skipped messages of /tf since the last status
  std::chrono::nanoseconds max_delay_{0};  ///< max delay of a message, since the last status
  /// Like measure(), but lets no exception out.
  const Guard guard_ = [this](const auto& body) { guarded([&] { measure(body); }); };
  Periodic periodic_;  ///< before the outputs, which add alarms to it
  SceneOutput output_;
  LostFrames lost_frames_;
  Diagnostics diagnostics_;
  TfReceiver tf_receiver_;
  IncompleteMessages incomplete_messages_;
  SceneCopier scene_copier_;
  BoxService box_service_;
  PathService path_service_;
  SweptOutput swept_output_;
  StoppingOutput stopping_output_;
  EarliestOutput earliest_output_;
  ros::Subscriber objects_subscriber_;
  ros::Subscriber object_subscriber_;
  ros::Subscriber neighbours_subscriber_;
  std::unique_ptr<ModelLoader> loader_;  ///< near the end: its thread uses the members above
  std::unique_ptr<MasterWatch> master_watch_;
};

}  // namespace link_bounds
