// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and deserialises /tf as bag_bounds and as rosbag do it. Each prints the same of the bag.
#ifdef LINK_BOUNDS_WITH_ROSBAG
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>
#endif

#include <cstdint>
#include <iostream>

#include "bench/common/processes.h"
#include "tools/bag_bounds/bag/bag_reader.h"
#include "world/tf/tf_message.h"

namespace link_bounds::bench {
namespace {

struct BagCounts {
  std::uint64_t messages = 0;
  std::uint64_t transforms = 0;
  double sum = 0;  ///< of all translations along x, so that nothing is left out
};

void print(const BagCounts& counts) {
  std::cout.precision(17);
  std::cout << counts.messages << ' ' << counts.transforms << ' ' << counts.sum << '\n';
}

}  // namespace

void readBagAsOurs(const Words& words) {
  BagReader reader({words[0]}, {"/tf"});
  BagCounts counts;
  TfMessage tf;
  for (BagMessage message; reader.next(message);) {
    tf.read(message.data, message.size);
    ++counts.messages;
    counts.transforms += tf.transforms.size();
    for (const TransformView& transform : tf.transforms)
      counts.sum += transform.parent_from_child.translation().x();
  }
  print(counts);
}

#ifdef LINK_BOUNDS_WITH_ROSBAG
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
#endif

}  // namespace link_bounds::bench
