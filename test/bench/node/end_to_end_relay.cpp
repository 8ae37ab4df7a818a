// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A node that computes nothing: answers each TFMessage with as many boxes as it has transforms.
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "link_bounds/AxisAlignedBoxArray.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "relay");
  ros::NodeHandle node, private_node("~");
  link_bounds::AxisAlignedBoxArray answer;
  const auto publisher = private_node.advertise<link_bounds::AxisAlignedBoxArray>("boxes", 200);
  const auto relay = [&](const tf2_msgs::TFMessageConstPtr& message) {
    const auto& transforms = message->transforms;
    answer.boxes.resize(transforms.size());
    for (std::size_t i = 0; i < transforms.size(); ++i) {
      answer.boxes[i].name = transforms[i].child_frame_id;
      answer.boxes[i].stamp = transforms[i].header.stamp;
    }
    answer.header = transforms.front().header;
    publisher.publish(answer);
  };
  const auto subscriber = node.subscribe<tf2_msgs::TFMessage>("/tf", 5000, relay, {},
                                                              ros::TransportHints().tcpNoDelay());
  ros::spin();
}
