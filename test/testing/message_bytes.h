// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The bytes of a message of ROS as a publisher sends them, without their length in front.
#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <vector>

namespace link_bounds {

template <class Message>
std::vector<std::uint8_t> messageBytes(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

}  // namespace link_bounds
