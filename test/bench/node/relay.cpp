// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A node that computes nothing: [BOXES [TOPIC BYTES HZ] ...]
// Answers each TFMessage with as many boxes as it has transforms, and further ones up to BOXES.
// Beside it, sends that many bytes on topics, that often, while somebody listens.
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "bench/common/processes.h"
#include "link_bounds/AxisAlignedBoxArray.h"

namespace link_bounds::bench {
namespace {

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

void runRelay(const Words& words) {
  ros::NodeHandle node, private_node("~");
  AxisAlignedBoxArray answer;
  const std::size_t least = words.empty() ? 0 : std::stoul(words[0]);
  const auto publisher = private_node.advertise<AxisAlignedBoxArray>("boxes", 200);
  const auto relay = [&](const tf2_msgs::TFMessageConstPtr& message) {
    const auto& transforms = message->transforms;
    answer.boxes.resize(std::max(transforms.size(), least));
    for (std::size_t i = 0; i < transforms.size(); ++i) {
      answer.boxes[i].name = transforms[i].child_frame_id;
      answer.boxes[i].stamp = transforms[i].header.stamp;
    }
    answer.header = transforms.front().header;
    publisher.publish(answer);
  };
  const auto subscriber = node.subscribe<tf2_msgs::TFMessage>("/tf", 5000, relay, {},
                                                              ros::TransportHints().tcpNoDelay());
  std::vector<std::thread> talkers;
  for (std::size_t i = 1; i + 2 < words.size(); i += 3) {
    const auto talker = private_node.advertise<std_msgs::String>(words[i], 1);
    talkers.emplace_back(talk, talker, std::stoul(words[i + 1]), std::stod(words[i + 2]));
  }
  ros::spin();
  for (std::thread& talker : talkers)
    talker.join();
}

}  // namespace link_bounds::bench
