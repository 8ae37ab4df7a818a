// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What roscpp itself reads, by its own parser.
#include "node/master/master_uri.h"

#include <ros/network.h>

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace link_bounds {

void checkMasterUri(int argc, char** argv) {
  std::string name = "ROS_MASTER_URI";
  const char* const set = std::getenv(name.c_str());
  std::string uri = set ? set : "";
  const std::string begin = "__master:=";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.compare(0, begin.size(), begin) != 0) continue;
    name = "__master";
    uri = argument.substr(begin.size());
  }
  if (uri.empty() && name != "__master") return;
  std::string host;
  std::uint32_t port = 0;
  if (ros::network::splitURI(uri, host, port) && port > 0 && port <= 65535) return;
  throw std::runtime_error(name + " is \"" + uri + "\"; it must be http://HOST:PORT");
}

}  // namespace link_bounds
