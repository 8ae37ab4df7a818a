// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects that the robot holds: markers that follow one of its links.
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
  std::shared_ptr<const ObjectContent> content;  ///< the newest; null: its grid is to be made again
  /// The last grid that was completed, perhaps of an older content; null before the first one.
  std::shared_ptr<const BodyGrid> grid;
  std::string frame;            ///< tf frame of the grid
  std::string problem;          ///< why there is no grid of the newest content; "" if there is one
  std::uint64_t first = 0;      ///< results of earlier requests are discarded
  std::uint64_t requested = 0;  ///< the last request
  std::uint64_t made = 0;       ///< the request of the grid, or of the problem

  std::shared_ptr<std::atomic<bool>> is_gone;  ///< true ends the making of its grids

  bool isNewest() const { return made == requested && grid && problem.empty(); }
};

/// Runs on the thread of the node, except the making of grids, which runs on `worker`.
class HeldObjects {
 public:
  using Objects = std::map<ObjectKey, HeldObject>;

  /// `on_change` is called when a grid or a problem appears or disappears.
  HeldObjects(ros::NodeHandle& private_node, TransformBuffer& tf, Worker& worker,
              ros::CallbackQueueInterface& queue, std::function<void()> on_change);
  HeldObjects(const HeldObjects&) = delete;
  HeldObjects& operator=(const HeldObjects&) = delete;

  const Objects& objects() const { return held_; }

  /// Names of markers that follow links but are not filtered, because there are too many or they
  /// cannot be used, each with the reason. The list has a max length.
  const std::map<std::string, std::string>& refused() const { return refused_; }

  /// The number of refused markers beyond that max length.
  std::size_t moreRefused() const { return more_refused_; }

  /// Takes over another robot, or other parameters.
  void adopt(std::shared_ptr<const FilteredRobot> robot);

  /// Removes objects whose lifetime is over. Call it regularly.
  void expire(ros::Time now);

  /// Call it after the clock jumped back or began to run.
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
  std::map<ObjectKey, std::string> asked_;  ///< the frame that a marker shall follow; "" if none
  std::map<std::string, std::string> refused_;
  std::size_t more_refused_ = 0;
  std::uint64_t requests_ = 0;
  IncompleteMessages incomplete_messages_;
  ros::Subscriber subscriber_;
};

}  // namespace link_bounds
