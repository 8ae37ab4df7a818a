// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and deserialises /tf as rosbag does it, or else as bag_bounds does it: BAG. A program for
// each, because its memory and time are those of the whole process, with the libraries it loads.
// Both print the same of a bag: messages, transforms, and the sum of all translations along x, so
// that nothing is left out.
#include <cstdint>
#include <exception>
#include <iostream>

#ifdef LINK_BOUNDS_WITH_ROSBAG
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>
#else
#include "tools/bag_bounds/bag/bag_reader.h"
#include "world/tf/tf_message.h"
#endif

namespace link_bounds::bench {
namespace {

struct BagCounts {
  std::uint64_t messages = 0;
  std::uint64_t transforms = 0;
  double sum = 0;
};

BagCounts read(const char* file) {
  BagCounts counts;
#ifdef LINK_BOUNDS_WITH_ROSBAG
  rosbag::Bag bag(file);
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery("/tf"))) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    ++counts.messages;
    counts.transforms += message->transforms.size();
    for (const geometry_msgs::TransformStamped& transform : message->transforms)
      counts.sum += transform.transform.translation.x;
  }
#else
  BagReader reader({file}, {"/tf"});
  TfMessage tf;
  for (BagMessage message; reader.next(message);) {
    tf.read(message.data, message.size);
    ++counts.messages;
    counts.transforms += tf.transforms.size();
    for (const TransformView& transform : tf.transforms)
      counts.sum += transform.parent_from_child.translation().x();
  }
#endif
  return counts;
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  if (argc != 2) return 1;
  const auto counts = link_bounds::bench::read(argv[1]);
  std::cout.precision(17);
  std::cout << counts.messages << ' ' << counts.transforms << ' ' << counts.sum << '\n';
} catch (const std::exception& error) {
  std::cerr << argv[0] << ": " << error.what() << '\n';
  return 1;
}
