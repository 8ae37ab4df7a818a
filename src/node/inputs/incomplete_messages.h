// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages that announce more than they have are refused: the type with which to subscribe to
// messages of strangers, or to serve their requests, and who looks at them.
#pragma once

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

/// A Message that roscpp reads by CheckedStream. Reading does not throw: roscpp would log each such
/// message, without its topic.
template <class Message>
struct Received : Message {
  bool is_complete = true;  ///< if not, the message is empty; see IncompleteMessages
};

/// Calls take(event) for each message on `topic`, on the thread of the node's queue. `queue` is how
/// many wait for it at most.
template <class Message, class Take>
ros::Subscriber subscribeReceived(ros::NodeHandle& node, const std::string& topic,
                                  std::uint32_t queue, Take take) {
  return node.subscribe<Received<Message>, const ros::MessageEvent<Received<Message>>&>(
      topic, queue, std::move(take), {}, ros::TransportHints().tcpNoDelay());
}

/// Of one thread.
class IncompleteMessages {
 public:
  /// Whether all of the message is there. If not, logs that, at a limited rate. `topic` may also be
  /// a service.
  template <class Message>
  bool accept(const Received<Message>& message, const std::string& topic,
              const std::string& sender) {
    if (!message.is_complete) log(topic, sender);
    return message.is_complete;
  }

 private:
  void log(const std::string& topic, const std::string& sender);

  RefusalLog log_{"a message on", "messages on further topics"};
};

extern const char* const kIncompleteMessage;  ///< why one is refused

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
