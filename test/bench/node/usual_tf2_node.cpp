// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The usual node of tf2: a TransformListener, and after each message a look-up of each frame and a
// message of loose boxes: boxes|markers
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_listener.h>

#include "bench/common/processes.h"
#include "bench/common/usual_tf2.h"

namespace link_bounds::bench {

void runUsualTf2(const Words& words) {
  const bool is_markers = words[0] == "markers";
  ros::NodeHandle node, private_node("~");
  const auto publisher = is_markers
                             ? private_node.advertise<visualization_msgs::MarkerArray>("boxes", 200)
                             : private_node.advertise<AxisAlignedBoxArray>("boxes", 200);
  // Without a thread of its own the listener is called first, since it subscribes first; roscpp
  // reads the bytes of a message once for both.
  const auto hints = ros::TransportHints().tcpNoDelay();
  tf2::BufferCore buffer;
  const tf2_ros::TransformListener listener(buffer, node, false, hints);
  const Aabb resting(Eigen::Vector3d(-0.1, -0.1, -0.2), Eigen::Vector3d(0.1, 0.1, 0.2));
  std::string base;
  std::vector<UsualLink> links;
  const auto answer = [&](const tf2_msgs::TFMessageConstPtr& message) {
    const auto& transforms = message->transforms;
    if (links.empty()) {
      base = transforms.front().header.frame_id;
      for (const auto& transform : transforms)
        links.push_back({transform.child_frame_id, resting});
    }
    if (is_markers)
      publisher.publish(usualMarkers(buffer, base, links));
    else
      publisher.publish(usualBoxes(buffer, base, links));
  };
  const auto subscriber = node.subscribe<tf2_msgs::TFMessage>("/tf", 5000, answer, {}, hints);
  ros::spin();
}

}  // namespace link_bounds::bench
