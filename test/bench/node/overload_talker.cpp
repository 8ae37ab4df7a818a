// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A node that computes nothing: overload_talker BOXES TOPIC BYTES HZ [TOPIC BYTES HZ ...]
// Answers each TFMessage with that many boxes, and beside it sends bytes on topics as often as
// asked.
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"

namespace {

/// Sends on one topic while ROS lives and somebody listens.
void talk(const ros::Publisher& publisher, std::size_t bytes, double hz) {
  std_msgs::String message;
  message.data.resize(bytes);
  ros::WallRate heard(hz), unheard(10);
  while (ros::ok()) {
    const bool is_heard = publisher.getNumSubscribers() > 0;
    if (is_heard) publisher.publish(message);
    (is_heard ? heard : unheard).sleep();
  }
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "talker");
  ros::NodeHandle node, private_node("~");
  link_bounds::AxisAlignedBoxArray answer;
  answer.boxes.resize(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0);
  for (auto& box : answer.boxes)
    box.name = "link_100";
  const auto boxes = private_node.advertise<link_bounds::AxisAlignedBoxArray>("boxes", 200);
  const auto relay = [&](const tf2_msgs::TFMessageConstPtr& message) {
    answer.header = message->transforms.front().header;
    for (auto& box : answer.boxes)
      box.stamp = answer.header.stamp;
    boxes.publish(answer);
  };
  const auto subscriber = node.subscribe<tf2_msgs::TFMessage>("/tf", 5000, relay, {},
                                                              ros::TransportHints().tcpNoDelay());
  std::vector<std::thread> threads;
  for (int i = 2; i + 2 < argc; i += 3) {
    const auto publisher = private_node.advertise<std_msgs::String>(argv[i], 1);
    threads.emplace_back(talk, publisher, std::strtoul(argv[i + 1], nullptr, 10),
                         std::strtod(argv[i + 2], nullptr));
  }
  ros::spin();
  for (std::thread& thread : threads)
    thread.join();
}
