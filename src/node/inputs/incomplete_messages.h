// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Refuses incomplete messages, whose bytes end before the announced length of a list or string.
// Received is the type for subscribers and services; IncompleteMessages checks and logs.
#pragma once

#include <ros/console.h>
#include <ros/message_event.h>
#include <ros/message_traits.h>
#include <ros/node_handle.h>
#include <ros/service_traits.h>

#include <cstdint>
#include <string>
#include <utility>

#include "node/inputs/checked_stream.h"
#include "world/log/refusal_log.h"

namespace link_bounds {

/// A Message that roscpp reads through CheckedStream. Reading does not throw: roscpp would log each
/// incomplete message without its topic.
template <class Message>
struct Received : Message {
  bool is_complete = true;  ///< if false, the message is empty; see IncompleteMessages
};

/// Calls take(event) for each message on `topic`, on the thread of the node's queue. `queue` is the
/// max number of waiting messages.
template <class Message, class Take>
ros::Subscriber subscribeReceived(ros::NodeHandle& node, const std::string& topic,
                                  std::uint32_t queue, Take take) {
  return node.subscribe<Received<Message>, const ros::MessageEvent<Received<Message>>&>(
      topic, queue, std::move(take), {}, ros::TransportHints().tcpNoDelay());
}

/// The reason for the log and for a response.
constexpr const char* kIncompleteMessage = "it is shorter than it says; correct its sender";

/// Not thread-safe.
class IncompleteMessages {
 public:
  /// True if the message is complete. If not, logs that, at a limited rate. `topic` may also be a
  /// service.
  template <class Message>
  bool accept(const Received<Message>& message, const std::string& topic,
              const std::string& sender) {
    if (!message.is_complete) log(topic, sender);
    return message.is_complete;
  }

 private:
  void log(const std::string& topic, const std::string& sender) {
    const auto line = log_.line(topic, kIncompleteMessage, sender, ros::SteadyTime::now());
    if (line) ROS_WARN_STREAM(*line);
  }

  RefusalLog log_{"a message on", "messages on further topics"};
};

}  // namespace link_bounds

namespace ros::message_traits {

template <class Message>
struct MD5Sum<link_bounds::Received<Message>> : MD5Sum<Message> {};
template <class Message>
struct DataType<link_bounds::Received<Message>> : DataType<Message> {};
template <class Message>
struct HasHeader<link_bounds::Received<Message>> : HasHeader<Message> {};

}  // namespace ros::message_traits

namespace ros::service_traits {

template <class Request>
struct MD5Sum<link_bounds::Received<Request>> : MD5Sum<Request> {};
template <class Request>
struct DataType<link_bounds::Received<Request>> : DataType<Request> {};

}  // namespace ros::service_traits

namespace ros::serialization {

template <class Message>
struct Serializer<link_bounds::Received<Message>> {
  template <class Stream>
  static void read(Stream& stream, link_bounds::Received<Message>& message) {
    const std::uint32_t size = stream.getLength();
    message.is_complete = link_bounds::readComplete<Message>(stream.advance(size), size, message);
  }
};

}  // namespace ros::serialization
