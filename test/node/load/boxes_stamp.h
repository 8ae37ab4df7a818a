// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The stamp of a message that begins with a header; the rest is not read, so that receiving many
// boxes takes little time.
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <cstdint>

namespace link_bounds {

struct BoxesStamp {
  std::uint32_t seq = 0;
  ros::Time stamp;
};

}  // namespace link_bounds

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<link_bounds::BoxesStamp> {
  static const char* value() { return "*"; }
  static const char* value(const link_bounds::BoxesStamp&) { return value(); }
};

template <>
struct DataType<link_bounds::BoxesStamp> {
  static const char* value() { return "*"; }
  static const char* value(const link_bounds::BoxesStamp&) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<link_bounds::BoxesStamp> {
  template <typename Stream>
  static void read(Stream& stream, link_bounds::BoxesStamp& message) {
    stream.next(message.seq);
    stream.next(message.stamp);
  }
};

}  // namespace serialization
}  // namespace ros
