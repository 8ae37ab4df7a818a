// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Queues without limit, so that only others can lose messages.
#include "soak_listener.h"

#include <geometry_msgs/Polygon.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cstdlib>

#include "link_bounds/AxisAlignedBoxArray.h"

namespace link_bounds {
namespace {

constexpr std::uint32_t kUnlimited = 0;

}  // namespace

SoakListener::SoakListener(ros::NodeHandle& node, const std::string& publisher)
    : publisher_(publisher) {
  const auto subscribe = [&](const std::string& topic, auto type, auto callback) {
    using Message = decltype(type);
    subscribers_.push_back(node.subscribe<Message>(
        topic, kUnlimited,
        [callback](const boost::shared_ptr<const Message>& message) { callback(*message); }, {},
        ros::TransportHints().tcpNoDelay()));
  };
  const auto ignore = [](const auto&) {};
  subscribe(publisher_ + "/boxes", AxisAlignedBoxArray(), [this](const auto&) { ++boxes_; });
  subscribe(publisher_ + "/groups", AxisAlignedBoxArray(), ignore);
  subscribe(publisher_ + "/footprint", geometry_msgs::Polygon(), ignore);
  subscribe(publisher_ + "/markers", visualization_msgs::MarkerArray(),
            [this](const auto&) { ++markers_; });
  subscribe("/diagnostics", diagnostic_msgs::DiagnosticArray(),
            [this](const auto& array) { onDiagnostics(array); });
}

void SoakListener::onDiagnostics(const diagnostic_msgs::DiagnosticArray& array) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& status : array.status) {
    if ("/" + status.name != publisher_ + ": boxes") continue;
    diagnostics_.clear();
    for (const auto& pair : status.values) {
      diagnostics_[pair.key] = pair.value;
      double& largest = largest_[pair.key];
      largest = std::max(largest, std::strtod(pair.value.c_str(), nullptr));
    }
  }
}

double SoakListener::diagnostic(const std::string& key) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = diagnostics_.find(key);
  return found == diagnostics_.end() ? 0 : std::strtod(found->second.c_str(), nullptr);
}

double SoakListener::largest(const std::string& key) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = largest_.find(key);
  return found == largest_.end() ? 0 : found->second;
}

}  // namespace link_bounds
