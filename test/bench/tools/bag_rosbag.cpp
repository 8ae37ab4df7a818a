// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and deserialises /tf as rosbag does it.
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include "bench/common/processes.h"
#include "bench/tools/bag_counts.h"

namespace link_bounds::bench {

void readBagAsRosbag(const Words& words) {
  rosbag::Bag bag(words[0]);
  BagCounts counts;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery("/tf"))) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    ++counts.messages;
    counts.transforms += message->transforms.size();
    for (const geometry_msgs::TransformStamped& transform : message->transforms)
      counts.sum += transform.transform.translation.x;
  }
  print(counts);
}

}  // namespace link_bounds::bench
