// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene and its inputs: tf, markers, meshes and the clock. The node and bag_bounds share it, so
// that the same messages give the same boxes.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>
#include <visualization_msgs/Marker.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "world/bodies/neighbour_sets.h"
#include "world/bodies/object_source.h"
#include "world/bodies/scene.h"
#include "world/log/repeat_log.h"
#include "world/tf/clock_watch.h"
#include "world/tf/transform_input.h"

namespace link_bounds {

/// Not copyable: it hands out references to itself.
class SceneFeed {
 public:
  struct Handlers {
    /// Requests the mesh of an object; returns at once. The mesh comes back through onMesh().
    std::function<void(const MeshRequest& request)> request_mesh;
    /// A box, a stamp or an incomplete name changed. Called only if there is a model, and at most
    /// once for each update, tick and jump of the clock.
    std::function<void()> on_news;
    HasLeft has_left = [](const std::string&) { return false; };  ///< whether a neighbour has ended
  };

  /// For `steady_now` see ClockWatch.
  explicit SceneFeed(Handlers handlers,
                     std::function<ros::SteadyTime()> steady_now = ros::SteadyTime::now);
  SceneFeed(const SceneFeed&) = delete;
  SceneFeed& operator=(const SceneFeed&) = delete;

  /// Starts over with a model. Objects and transforms stay. Does not call on_news.
  void adopt(std::shared_ptr<const Model> model, ros::Time now);

  /// While `joins` is true, messages are only collected. They take effect in the next update() or
  /// tick, which must come before anything else reads the scene.
  void setJoining(bool joins) { joins_ = joins; }

  /// Updates the scene with all collected messages.
  void update(ros::Time now);

  /// The number of messages since the last call that had no update of their own, see setJoining().
  std::size_t takeJoined() { return std::exchange(joined_, 0); }

  /// See TransformInput.
  void onTransforms(const std::vector<TransformView>& transforms, bool is_static,
                    const TransformInput::Publisher& publisher, ros::Time now,
                    ros::SteadyTime arrival);

  /// The markers of one message. They are moved from.
  void onMarkers(visualization_msgs::Marker* markers, std::size_t count,
                 const std::string& publisher, ros::Time now);

  /// Takes a message on ~boxes of another node.
  void onNeighbour(const AxisAlignedBoxArray& boxes, const NeighbourSender& sender, ros::Time now);

  void onMesh(const MeshRequest& request, const LoadedMesh& mesh, ros::Time now);

  /// To be called every kTick [s]: drops boxes that have become too old, max one tick late.
  void onTick(ros::Time now);
  static constexpr double kTick = 0.05;

  /// To be called after onTick(): see TransformBuffer::forgetQuiet().
  void forgetQuietFrames(ros::SteadyTime now) { tf_.forgetQuiet(now); }

  /// See TransformInput.
  LateTexts takeLatePublishers() { return input_.takeLatePublishers(); }

  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  TransformBuffer& tf() { return tf_; }
  const TransformBuffer& tf() const { return tf_; }
  const ClockWatch& clock() const { return clock_; }

 private:
  void taken(bool is_changed, ros::Time now);
  void updatePoses(ros::Time now);
  void observeClock(ros::Time now);
  void logJump();
  void onNews();

  Handlers handlers_;
  TransformBuffer tf_;
  Scene scene_{tf_};
  TransformInput input_;
  ObjectSource object_source_;
  NeighbourSets neighbours_{scene_.objects};
  ClockWatch clock_;
  RepeatLog jump_log_;
  bool joins_ = false;
  bool has_new_transforms_ = false;  ///< this, is_changed_ and taken_: since the last update
  bool is_changed_ = false;
  std::size_t taken_ = 0;   ///< number of messages
  std::size_t joined_ = 0;  ///< see takeJoined()
};

}  // namespace link_bounds
