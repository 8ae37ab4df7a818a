// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From clouds and tf to clouds without the robot. Messages wait here until tf reaches their time.
#pragma once

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <deque>
#include <memory>
#include <string>

#include "node/inputs/incomplete_messages.h"
#include "node/inputs/tf_receiver.h"
#include "tools/cloud_filter/filter_health.h"
#include "tools/cloud_filter/robot_loading.h"
#include "world/cloud/robot_points.h"
#include "world/tf/clock_watch.h"
#include "world/tf/transform_input.h"

namespace link_bounds {

/// Everything here runs on the thread that calls spin().
class CloudFilterNode {
 public:
  CloudFilterNode();
  CloudFilterNode(const CloudFilterNode&) = delete;
  CloudFilterNode& operator=(const CloudFilterNode&) = delete;

  /// Handles what arrives, until the program is to end.
  void spin();

  int exitCode() const { return loading_->hasFailed() ? 1 : 0; }

 private:
  using Cloud = Received<sensor_msgs::PointCloud2>;
  using Scan = Received<sensor_msgs::LaserScan>;

  /// A cloud or a scan.
  struct Waiting {
    boost::shared_ptr<Cloud> cloud;
    boost::shared_ptr<Scan> scan;
    ros::SteadyTime since;

    const std_msgs::Header& header() const { return cloud ? cloud->header : scan->header; }
    const char* topic() const { return cloud ? kCloudTopic.name : kScanTopic.name; }
  };

  /// What could be done with a message now.
  struct Outcome {
    bool is_done = false;
    bool may_come = false;  ///< if it was not done: with more of tf
    std::string reason;     ///< why it was not
  };

  void add(Waiting waiting);
  void filterWaiting();
  void giveUp(const Waiting& waiting, const std::string& reason, bool is_late);
  Outcome filter(const Waiting& waiting);
  Outcome filter(const Waiting& waiting, const CloudPoints& points);
  void send(const Waiting& waiting, const std::vector<RobotPoint>& removed);
  void adopt(std::shared_ptr<const FilteredRobot> robot);
  void onTransforms(const TfReceiver::Event& event, bool is_static);
  void observeClock();

  ros::CallbackQueue queue_;  ///< first: what follows posts into it
  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  TransformBuffer tf_;
  TransformInput tf_input_;
  ClockWatch clock_;
  std::deque<Waiting> waiting_;
  std::shared_ptr<const FilteredRobot> robot_;  ///< null until it is loaded
  std::vector<TransformBuffer::Hold> frames_;   ///< by link
  std::vector<ScannedLink> links_;
  FilterHealth health_;
  IncompleteMessages incomplete_messages_;
  ros::Publisher output_, scan_output_, robot_points_;
  TfReceiver tf_receiver_;
  ros::Subscriber cloud_subscriber_, scan_subscriber_;
  std::unique_ptr<RobotLoading> loading_;  ///< last: its thread ends before the rest goes
};

}  // namespace link_bounds
