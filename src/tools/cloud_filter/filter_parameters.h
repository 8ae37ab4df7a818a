// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The parameters of cloud_filter and its topics: one table each, for the reader and --help.
#pragma once

#include <array>
#include <string>

#include "node/interface/parameter_table.h"
#include "node/interface/topics.h"

namespace link_bounds {

/// Meanings and units are in visitFilterParameters().
struct FilterParameters : LinkParameters {
  FilterParameters() { padding = 0.01; }

  double max_wait = 0.2;
  double timeout = 1;
  std::string late = "drop";
  bool keep_organized = true;
  double min_distance = 0;
  bool shadow = false;
  int threads = 1;
};

namespace rules {

inline constexpr auto late = oneOf("must be drop or pass", "drop", "pass");
inline constexpr auto wait = within(0, 10, "must be a number of seconds from 0 to 10");
inline constexpr auto threads = within(1, 64, "must be a whole number from 1 to 64");

}  // namespace rules

/// Calls visit(name, value, rule, meaning) for each private parameter.
template <class AnyParameters, class Visitor>
void visitFilterParameters(AnyParameters& p, Visitor&& visit) {
  visitLinkParameters(p, visit,
                      "metres, 0 to 1e6; points at most so far from a link are the robot's");
  visit("max_wait", p.max_wait, rules::wait, "wall seconds, 0 to 10, that a cloud waits for tf");
  visit("timeout", p.timeout, rules::notNegative,
        "ROS seconds; transforms farther apart do not tell where the robot was between them; 0 = "
        "they always do");
  visit("late", p.late, rules::late,
        "drop or pass: what becomes of a cloud for which tf did not come; pass sends it on with "
        "the robot's points");
  visit("keep_organized", p.keep_organized, rules::any<bool>,
        "points of the robot become NaN; if not, they are left out, and the cloud has one row");
  visit("min_distance", p.min_distance, rules::length,
        "metres, 0 to 1e6; points nearer to the origin of the sensor's frame are removed, too");
  visit("shadow", p.shadow, rules::any<bool>,
        "true removes points, too, that a link hides from the origin of the sensor's frame");
  visit("threads", p.threads, rules::threads, "1 to 64, for one cloud");
  visit("tf_prefix", p.tf_prefix, rules::any<std::string>,
        "goes before link names in tf; if not set here, it is found upwards as "
        "robot_state_publisher finds it");
}

constexpr TopicName kCloudTopic{"~input", "sensor_msgs/PointCloud2", "subscribed"};
constexpr TopicName kScanTopic{"~input_scan", "sensor_msgs/LaserScan", "subscribed"};
constexpr TopicName kCloudOutput{"~output", "sensor_msgs/PointCloud2",
                                 "each cloud of ~input without the points of the robot"};
constexpr TopicName kScanOutput{
    "~output_scan", "sensor_msgs/LaserScan",
    "each scan of ~input_scan; ranges that the robot reflected are NaN"};
constexpr TopicName kRobotPoints{"~robot_points", "sensor_msgs/PointCloud2",
                                 "the points that ~output lacks; only while somebody listens"};
constexpr TopicName kNearestPoints{
    "~nearest", "link_bounds/DistanceArray",
    "for each filtered cloud, the point of ~output that is the nearest one to each link; only "
    "while somebody listens"};
constexpr TopicName kHeldObjects{
    "~objects", "visualization_msgs/MarkerArray",
    "subscribed; markers that follow a link count as a part of the robot"};

constexpr std::array<TopicName, 10> kFilterTopics{
    {kCloudTopic, kScanTopic, kCloudOutput, kScanOutput, kRobotPoints, kNearestPoints,
     kDiagnosticsTopic, kTfTopic, kTfStaticTopic, kHeldObjects}};

constexpr TopicName kFilterReload{
    "~reload", "std_srvs/Trigger",
    "reads robot_description and all parameters again and answers after the swap, with the "
    "warnings that it logs; on failure keeps the old robot and says why"};

constexpr std::array<TopicName, 1> kFilterServices{{kFilterReload}};

}  // namespace link_bounds
