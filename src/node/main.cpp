// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Starts the node.
#include "node/interface/command_line.h"
#include "node/master/node_program.h"
#include "node/publisher_node.h"
#include "node/upkeep/heap.h"

namespace {

int spin() {
  link_bounds::PublisherNode node;
  node.spin();
  return node.exitCode();
}

}  // namespace

int main(int argc, char** argv) {
  link_bounds::returnLargeBlocks();
  return link_bounds::runNode(argc, argv,
                              {"link_bounds_publisher", LINK_BOUNDS_VERSION, link_bounds::usage,
                               link_bounds::publisherTables(), spin});
}
