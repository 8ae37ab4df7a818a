// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rounds of objects of all kinds.
#include "soak_objects.h"

#include <visualization_msgs/MarkerArray.h>

#include <chrono>
#include <cmath>

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::chrono::milliseconds kPeriod(50);
constexpr int kNewPerStep = 12;
constexpr std::uint64_t kStepsAlive = 20;
constexpr std::uint64_t kStepsPerClearing = 400;
constexpr int kKinds = 12;  // of markers, numbered from 0; text is one of them
constexpr int kPoints = 300;

void addPoints(double phase, Marker& marker) {
  for (int i = 0; i < kPoints; ++i) {
    geometry_msgs::Point point;
    point.x = 0.01 * i;
    point.y = std::sin(0.1 * i + phase);
    point.z = std::cos(0.2 * i + phase);
    marker.points.push_back(point);
  }
}

bool takesPoints(int kind) {
  return kind == Marker::LINE_STRIP || kind == Marker::LINE_LIST || kind == Marker::CUBE_LIST ||
         kind == Marker::SPHERE_LIST || kind == Marker::POINTS || kind == Marker::TRIANGLE_LIST;
}

Marker object(int id, std::uint64_t step, const std::string& frame) {
  Marker marker;
  marker.header.frame_id = frame;
  if (id % 3 == 0) marker.header.stamp = ros::Time::now();
  marker.ns = "soak";
  marker.id = static_cast<std::int32_t>(step % kStepsAlive) * kNewPerStep + id;
  marker.type = id % kKinds;
  marker.pose.orientation.w = std::cos(0.1 * static_cast<double>(step));
  marker.pose.orientation.x = std::sin(0.1 * static_cast<double>(step));
  marker.scale.x = marker.scale.y = marker.scale.z = 0.1;
  if (id % 4 == 0) marker.lifetime = ros::Duration(0.2);
  if (takesPoints(marker.type)) addPoints(0.1 * static_cast<double>(step), marker);
  if (marker.type == Marker::MESH_RESOURCE) {
    marker.mesh_resource = "package://link_bounds/launch/demo/meshes/pedestal.stl";
  }
  return marker;
}

}  // namespace

SoakObjects::SoakObjects(ros::NodeHandle& node, const std::string& publisher,
                         std::vector<std::string> frames)
    : frames_(std::move(frames)),
      publisher_(node.advertise<MarkerArray>(publisher + "/objects", 1000)) {}

void SoakObjects::start() {
  rounds_.emplace(kPeriod, [this] { step(); });
}

void SoakObjects::stop() {
  rounds_.reset();
  MarkerArray array;
  array.markers.resize(1);
  array.markers[0].action = Marker::DELETEALL;
  publisher_.publish(array);
}

/// Adds objects in one round and deletes them in the next.
void SoakObjects::step() {
  MarkerArray array;
  for (int id = 0; id < kNewPerStep; ++id) {
    array.markers.push_back(object(id, steps_, frames_[steps_ % frames_.size()]));
    if ((steps_ / kStepsAlive) % 2 == 1) array.markers.back().action = Marker::DELETE;
  }
  if (steps_ % kStepsPerClearing == kStepsPerClearing - 1) {
    array.markers.back().action = Marker::DELETEALL;
  }
  publisher_.publish(array);
  sent_ += kNewPerStep;
  ++steps_;
}

}  // namespace link_bounds
