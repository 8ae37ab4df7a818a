// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Topic and publisher are those of the node.
#include "tools/bag_bounds/boxes/boxes_bag.h"

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <algorithm>

#include "node/outputs/messages/box_message.h"
#include "tools/bag_bounds/scene/record_time.h"

namespace link_bounds {
namespace {

constexpr char kNode[] = "/link_bounds_publisher";

BagTopic boxesTopic() {
  return {std::string(kNode) + "/boxes",
          ros::message_traits::datatype<AxisAlignedBoxArray>(),
          ros::message_traits::md5sum<AxisAlignedBoxArray>(),
          ros::message_traits::definition<AxisAlignedBoxArray>(),
          kNode,
          true};
}

/// Restores the stamp 0 of recorded transforms, for which kStampOfZero stands.
void restoreZero(ros::Time& stamp) {
  if (stamp == kStampOfZero) stamp = ros::Time();
}

}  // namespace

BoxesBag::BoxesBag(const std::string& file)
    : writer_(file), topic_(writer_.addTopic(boxesTopic())) {}

/// Writes at 1 ns or later: rosbag play refuses messages of time 0.
void BoxesBag::write(const Scene& scene, std::int64_t now) {
  fillBoxes(scene, message_);
  restoreZero(message_.header.stamp);
  for (AxisAlignedBox& box : message_.boxes)
    restoreZero(box.stamp);
  bytes_.resize(ros::serialization::serializationLength(message_));
  const auto size = static_cast<std::uint32_t>(bytes_.size());
  ros::serialization::OStream stream(bytes_.data(), size);
  ros::serialization::serialize(stream, message_);
  writer_.write(topic_, std::clamp<std::int64_t>(now, 1, kMaxTime), bytes_.data(), size);
}

}  // namespace link_bounds
