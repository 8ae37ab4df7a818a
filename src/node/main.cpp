// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the node.
#include <malloc.h>
#include <ros/ros.h>

#include <csignal>
#include <cstring>
#include <iostream>

#include "publisher_node.h"
#include "usage.h"

namespace {

constexpr int kLargeBlock = 1 << 20;  // bytes

/// Large blocks go back to the system when they are freed. By itself the C library would keep
/// blocks as large as the largest one that was ever freed.
void giveBackLargeBlocks() {
  mallopt(M_MMAP_THRESHOLD, kLargeBlock);
  mallopt(M_TRIM_THRESHOLD, 2 * kLargeBlock);
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--help") == 0 || std::strcmp(argv[i], "-h") == 0) {
      std::cout << link_bounds::usage();
      return 0;
    }
  }
  giveBackLargeBlocks();
  ros::init(argc, argv, "link_bounds_publisher");
  // roscpp handles SIGINT only; roslaunch and service managers also send SIGTERM.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  link_bounds::PublisherNode node;
  ros::spin();
  return node.exitCode();
}
