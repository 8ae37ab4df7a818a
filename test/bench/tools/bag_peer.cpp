// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and deserialises /tf as rosbag does it: bag_peer FILE
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include "bench/tools/bag_counts.h"

namespace {

void read(const char* file) {
  rosbag::Bag bag(file);
  link_bounds::bench::BagCounts counts;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery("/tf"))) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    ++counts.messages;
    counts.transforms += message->transforms.size();
    for (const geometry_msgs::TransformStamped& transform : message->transforms)
      counts.sum += transform.transform.translation.x;
  }
  print(counts);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc == 2) read(argv[1]);
  return argc == 2 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "bag_peer: " << error.what() << '\n';
  return 1;
}
