// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and deserialises /tf as bag_bounds does it: bag_ours FILE
#include "bench/tools/bag_counts.h"
#include "tools/bag_bounds/bag/bag_reader.h"
#include "world/tf/tf_message.h"

namespace link_bounds::bench {
namespace {

void read(const std::string& file) {
  BagReader reader({file}, {"/tf"});
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

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) try {
  if (argc == 2) link_bounds::bench::read(argv[1]);
  return argc == 2 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "bag_ours: " << error.what() << '\n';
  return 1;
}
