// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Removes the robot from clouds and scans. Messages wait here until tf reaches their time.
#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "node/inputs/incomplete_messages.h"
#include "node/inputs/tf_receiver.h"
#include "node/loading/robot_loading.h"
#include "node/threads/timed_queue.h"
#include "tools/cloud_filter/filter_health.h"
#include "tools/cloud_filter/held_objects.h"
#include "world/cloud/robot_points.h"
#include "world/tf/clock_watch.h"
#include "world/tf/transform_input.h"

namespace link_bounds {

/// Everything here runs on the thread that calls spin().
class CloudFilterNode {
 public:
  /// The namespace of `private_node` is the name of the node. `on_failure`: see RobotLoading.
  CloudFilterNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                  std::function<void()> on_failure);
  CloudFilterNode(const CloudFilterNode&) = delete;
  CloudFilterNode& operator=(const CloudFilterNode&) = delete;

  /// Handles what arrives, until ROS shuts down or stop() is called.
  void spin();

  /// Any thread may call it; it returns at once.
  void stop() { is_stopping_ = true; }

  int exitCode() const { return loading_->hasFailed() ? 1 : 0; }

 private:
  using Cloud = Received<sensor_msgs::PointCloud2>;
  using Scan = Received<sensor_msgs::LaserScan>;
  using Loading = RobotLoading<FilteredRobot, FilterParameters>;

  /// A cloud or a scan that waits; the other pointer is null.
  struct Waiting {
    boost::shared_ptr<Cloud> cloud;
    boost::shared_ptr<Scan> scan;
    ros::SteadyTime since;
    std::optional<TimeSpan> span = std::nullopt;  ///< of the times of its points, once known
    bool was_first = false;                       ///< it has been the first of its input

    std::size_t bytes() const;  ///< of the members of variable length
    std::string fault() const;  ///< why it cannot be read; "" if it can
    const std_msgs::Header& header() const { return cloud ? cloud->header : scan->header; }
    const char* topic() const { return cloud ? kCloudTopic.name : kScanTopic.name; }
  };

  /// The messages of one topic that wait, the oldest first.
  struct Input {
    std::deque<Waiting> waiting;
    std::string waits_for = "";  ///< what the first message lacks from tf; "" if nothing
    std::string waits_in = "";   ///< the frame of that message
  };

  /// The result of trying to filter a message.
  struct Outcome {
    bool is_done = false;
    bool may_come = false;  ///< if it is not done: more transforms may help
    std::string reason;     ///< why it is not done
  };

  void subscribe();
  Loading::Handlers handlers(std::function<void()> on_failure);
  void takeAll();
  template <class Message>
  bool isComplete(const Message& message, const char* topic, const std::string& sender);
  void add(Waiting waiting);
  Input& inputOf(const Waiting& waiting) { return waiting.cloud ? clouds_ : scans_; }
  std::size_t waitingBytes() const;
  void giveUpOldest(Input& input);
  bool filterNext();
  bool filterFirst(Input& input);
  void giveUp(const Waiting& waiting, const std::string& reason, bool is_late);
  Outcome filter(Waiting& waiting);
  Outcome filter(Waiting& waiting, const CloudPoints& points);
  void send(const Waiting& waiting, const std::vector<RobotPoint>& removed);
  void publish(const Waiting& waiting);
  void sendNearest(const std_msgs::Header& header, const CloudPoints& points,
                   const std::vector<RobotPoint>& removed);
  void adopt(std::shared_ptr<const FilteredRobot> robot);
  void listBodies();
  void add(const std::string& name, const std::string& frame,
           const std::shared_ptr<const BodyGrid>& grid);
  std::vector<std::string> heldProblems() const;
  void onTransforms(const TfReceiver::Event& event, bool is_static);
  ros::Time now() const;
  void observeClock();

  TimedQueue queue_;  ///< first, because later members post into it
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  TransformBuffer tf_;
  TransformInput tf_input_;
  ClockWatch clock_;
  ros::Time simulated_now_;  ///< the last time of /clock that was handled
  Input clouds_, scans_;     // separate, so that neither delays the other while it waits for tf
  std::size_t clouds_taken_ = 0, scans_taken_ = 0, transforms_taken_ = 0;  ///< in one takeAll()
  std::shared_ptr<const FilteredRobot> robot_;  ///< null until it is loaded
  // Bodies as parallel lists, links before held objects:
  std::vector<std::string> names_;
  std::vector<TransformBuffer::Hold> frames_;
  std::vector<std::shared_ptr<const BodyGrid>> grids_;
  std::vector<ScannedLink> links_;
  std::vector<std::string> incomplete_;  ///< names of which something is missing
  FilterHealth health_;
  IncompleteMessages incomplete_messages_;
  ros::Publisher output_, scan_output_, robot_points_, nearest_;
  TfReceiver tf_receiver_;
  ros::Subscriber cloud_subscriber_, scan_subscriber_;
  ros::Subscriber clock_subscriber_;  ///< only where simulated time is in use
  std::atomic<bool> is_stopping_{false};
  std::unique_ptr<HeldObjects> held_;
  std::unique_ptr<Loading> loading_;  ///< last: its thread ends before other members do
};

}  // namespace link_bounds
