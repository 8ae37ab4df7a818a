// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that a RecordedScene takes as if they were in a bag.
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <string>

#include "testing/random_carriers.h"
#include "tools/bag_bounds/scene/recorded_scene.h"

namespace link_bounds {

/// As RecordedScene::take(), at a record time [ns].
template <class Message>
bool takeMessage(RecordedScene& scene, const std::string& topic, const Message& message,
                 std::int64_t time) {
  const std::string type = ros::message_traits::datatype(message), sender = "/sender";
  const ros::SerializedMessage bytes = ros::serialization::serializeMessage(message);
  const auto size = static_cast<std::uint32_t>(bytes.num_bytes - 4);  // without their length
  return scene.take({&topic, &type, &sender, time, bytes.message_start, size});
}

inline void takeMessage(RecordedScene& scene, const CarrierMessage& message) {
  if (message.transforms.empty()) {
    takeMessage(scene, "/objects", message.marker, message.time);
    return;
  }
  tf2_msgs::TFMessage transforms;
  transforms.transforms = message.transforms;
  takeMessage(scene, message.is_static ? "/tf_static" : "/tf", transforms, message.time);
}

}  // namespace link_bounds
