// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What the robot holds: markers that follow one of its links.
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "node/inputs/incomplete_messages.h"
#include "node/threads/worker.h"
#include "tools/cloud_filter/filtered_robot.h"
#include "world/bodies/object_source.h"

namespace link_bounds {

struct HeldObject {
  std::shared_ptr<const ObjectContent> content;  ///< the newest; null: to be made again
  /// Of an earlier content, while that of the newest one is being made; null before the first.
  std::shared_ptr<const BodyGrid> grid;
  std::string frame;        ///< of the grid
  std::string problem;      ///< why there is no grid of the newest content; "" if there is one
  std::uint64_t first = 0;  ///< request of which a grid may still be used; earlier ones are over
  std::uint64_t requested = 0;  ///< the last request
  std::uint64_t made = 0;       ///< the request of the grid, or of the problem

  std::shared_ptr<std::atomic<bool>> is_gone;  ///< ends the making of grids

  bool isNewest() const { return made == requested && grid && problem.empty(); }
};

/// All runs on the thread of the node, but the making of grids, for which `worker` is.
class HeldObjects {
 public:
  using Objects = std::map<ObjectKey, HeldObject>;

  /// `on_change` is called when a grid or a problem came or went.
  HeldObjects(ros::NodeHandle& private_node, TransformBuffer& tf, Worker& worker,
              ros::CallbackQueueInterface& queue, std::function<void()> on_change);
  HeldObjects(const HeldObjects&) = delete;
  HeldObjects& operator=(const HeldObjects&) = delete;

  const Objects& objects() const { return held_; }

  /// Markers that follow links and are not filtered, because there are too many or because they
  /// cannot be used: names and why. Of very many, the first ones.
  const std::map<std::string, std::string>& refused() const { return refused_; }

  /// How many more there are.
  std::size_t moreRefused() const { return more_refused_; }

  /// Another robot, or other parameters.
  void adopt(std::shared_ptr<const FilteredRobot> robot);

  /// To be called now and then: ends lifetimes.
  void expire(ros::Time now);

  /// After the clock jumped back or began to run.
  void restart(ros::Time now);

 private:
  using Markers = Received<visualization_msgs::MarkerArray>;

  void onMarkers(const ros::MessageEvent<Markers>& event);
  void update();
  bool isHeld(const ObjectContent& content) const;
  void refuse(const std::string& name, const std::string& reason);
  void request(const ObjectKey& key, HeldObject& held);
  void take(const ObjectKey& key, std::uint64_t request, const std::string& frame,
            std::shared_ptr<const BodyGrid> grid, const std::string& problem);

  Worker& worker_;
  ros::CallbackQueueInterface& queue_;
  std::function<void()> on_change_;
  FrameTracker frames_;  ///< has no fixed frame: only names and lifetimes count
  LiveObjects objects_{frames_};
  ObjectSource source_{objects_, [](const MeshRequest&) {}};
  std::shared_ptr<const FilteredRobot> robot_;
  Objects held_;
  std::map<ObjectKey, std::string> asked_;  ///< the frame that a marker asked to follow
  std::map<std::string, std::string> refused_;
  std::size_t more_refused_ = 0;
  std::uint64_t requests_ = 0;
  IncompleteMessages incomplete_messages_;
  ros::Subscriber subscriber_;
};

}  // namespace link_bounds
