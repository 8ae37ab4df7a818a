// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A tf2_msgs/TFMessage whose names are views into its bytes: roscpp's own type allocates memory for
// each name.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/serialization.h>
#include <tf2_msgs/TFMessage.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <mutex>
#include <string_view>
#include <vector>

#include "world/tf/tf2_pose.h"

namespace link_bounds {

/// One transform. Its names are views into a message, which must outlive it. One leading slash is
/// removed, as in tf2.
struct TransformView {
  TransformView(const geometry_msgs::TransformStamped& transform);
  TransformView(std::string_view parent_name, std::string_view child_name, std::string_view bytes,
                ros::Time time)
      : parent(parent_name), child(child_name), names(bytes), stamp(time) {}

  std::string_view parent;
  std::string_view child;
  std::string_view names;  ///< the serialised bytes of both names; empty if not received
  ros::Time stamp;
  Tf2Pose parent_from_child;
};

/// Why the transform can never be used, by the rules of tf2's setTransform, with the remedy; null
/// if it can. Does not check whether a frame is its own parent.
const char* whyRefused(const TransformView& transform);

/// Whether tf2 and ros::Time can handle a stamp. Bytes from the network can hold any number.
bool isTime(const ros::Time& stamp);

struct TfMessage {
  TfMessage() = default;
  TfMessage(const TfMessage&) = delete;
  TfMessage& operator=(const TfMessage&) = delete;

  /// Reads a serialised TFMessage into memory that is reused. Throws an exception of
  /// ros::serialization if the data is too short. A skipped message is not read and has no
  /// transforms.
  void read(const std::uint8_t* data, std::uint32_t size);

  /// The memory that the message holds [bytes].
  std::size_t capacity() const {
    return bytes.capacity() + transforms.capacity() * sizeof(TransformView);
  }

  bool is_skipped = false;                ///< see TfMessageMemory::skip()
  std::vector<TransformView> transforms;  ///< their names are views into `bytes`
  std::vector<std::uint8_t> bytes;
};

/// Memory that each message of a topic reuses. Thread-safe: if two nodelets of a process subscribe
/// to a topic, roscpp deserialises each message once, on the thread of either nodelet.
class TfMessageMemory {
 public:
  /// A message to read into: the previous one, or a new one if somebody still holds the previous
  /// one.
  boost::shared_ptr<TfMessage> lend();

  /// Whether messages that are lent from now on are skipped.
  void skip(bool skips);

  /// To be called now and then: frees the memory if large messages made it exceed 1 MiB.
  void giveBack();

 private:
  std::mutex mutex_;
  boost::shared_ptr<TfMessage> message_;  ///< guarded by mutex_, like skips_
  bool skips_ = false;
};

}  // namespace link_bounds

namespace ros::message_traits {

template <>
struct MD5Sum<link_bounds::TfMessage> : MD5Sum<tf2_msgs::TFMessage> {};
template <>
struct DataType<link_bounds::TfMessage> : DataType<tf2_msgs::TFMessage> {};

}  // namespace ros::message_traits

namespace ros::serialization {

template <>
struct Serializer<link_bounds::TfMessage> {
  template <class Stream>
  static void read(Stream& stream, link_bounds::TfMessage& message) {
    const std::uint32_t size = stream.getLength();
    message.read(stream.advance(size), size);
  }
};

}  // namespace ros::serialization
