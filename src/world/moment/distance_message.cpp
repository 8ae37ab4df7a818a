// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names, stamps and levels of the bodies of a moment.
#include "world/moment/distance_message.h"

#include <algorithm>

#include "link_bounds/ros/messages.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

static_assert(Distance::BOX == static_cast<std::uint8_t>(DistanceLevel::kBox));
static_assert(Distance::HULL == static_cast<std::uint8_t>(DistanceLevel::kHull));
static_assert(Distance::MESH == static_cast<std::uint8_t>(DistanceLevel::kMesh));

}  // namespace

Distance toMessage(const Moment& moment, const FoundPair& pair) {
  const Moment::Body& first = moment.bodies[pair.first];
  const Moment::Body& second = moment.bodies[pair.second];
  const BodyDistance& found = pair.distance;
  Distance message;
  message.first = moment.name(first);
  message.second = moment.name(second);
  message.stamp = timeFrom(olderStamp(first.stamp, second.stamp));
  message.distance = found.lower;
  message.distance_max = found.upper;
  message.on_first = toPoint(found.on_first);
  message.on_second = toPoint(found.on_second);
  message.normal = toVector3(found.normal);
  message.level = static_cast<std::uint8_t>(found.level);
  return message;
}

BodyDistance bodyDistanceOf(const Distance& message) {
  const auto vector = [](const auto& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  return {message.distance,         message.distance_max,
          vector(message.on_first), vector(message.on_second),
          vector(message.normal),   static_cast<DistanceLevel>(message.level)};
}

BoxOverlap toMessage(const Moment& moment, const BoxPair& pair) {
  BoxOverlap message;
  message.first = moment.name(moment.bodies[pair.first]);
  message.second = moment.name(moment.bodies[pair.second]);
  message.distance = pair.distance;
  return message;
}

Distance nearestOf(const std::vector<Distance>& distances, double limit) {
  const auto nearest =
      std::min_element(distances.begin(), distances.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (nearest != distances.end()) return *nearest;
  Distance none;
  none.distance = limit;
  none.distance_max = limit;
  none.level = Distance::BOX;
  return none;
}

}  // namespace link_bounds
