// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and deserialises /tf as bag_bounds does it.
#include "bench/common/processes.h"
#include "bench/tools/bag_counts.h"
#include "tools/bag_bounds/bag/bag_reader.h"
#include "world/tf/tf_message.h"

namespace link_bounds::bench {

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

}  // namespace link_bounds::bench
