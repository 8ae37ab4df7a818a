// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The usual node of tf2: what a TransformListener does with each message, then markers of loose
// boxes of all its frames.
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "bench/common/usual_tf2.h"

using namespace link_bounds;

int main(int argc, char** argv) {
  ros::init(argc, argv, "usual_tf2");
  ros::NodeHandle node, private_node("~");
  const Aabb resting(Eigen::Vector3d(-0.1, -0.1, -0.2), Eigen::Vector3d(0.1, 0.1, 0.2));
  tf2::BufferCore buffer;
  std::string base;
  std::vector<bench::UsualLink> links;
  const auto publisher = private_node.advertise<visualization_msgs::MarkerArray>("boxes", 200);
  const auto answer = [&](const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
    const auto& transforms = event.getConstMessage()->transforms;
    if (links.empty()) {
      base = transforms.front().header.frame_id;
      for (const auto& transform : transforms)
        links.push_back({transform.child_frame_id, resting});
    }
    for (const auto& transform : transforms)
      buffer.setTransform(transform, event.getPublisherName());
    publisher.publish(bench::usualMarkers(buffer, base, links));
  };
  const auto subscriber =
      node.subscribe<tf2_msgs::TFMessage, const ros::MessageEvent<const tf2_msgs::TFMessage>&>(
          "/tf", 5000, answer, {}, ros::TransportHints().tcpNoDelay());
  ros::spin();
}
