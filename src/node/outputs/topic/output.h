// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A topic on which publishing never waits for another topic, and whose queues are bounded in bytes.
//
// ros::Publisher::publish() serialises under a lock that all topics share: a thread of low priority
// that publishes a large message lets all others wait. Here a message is serialised without a lock
// and then given to the connections. roscpp bounds the queue of a subscriber in messages only.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <boost/signals2/connection.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace link_bounds {

/// How many messages may wait for one subscriber: long enough on a busy machine. kMaxBytes below
/// bounds their bytes.
constexpr std::uint32_t kBoxesQueue = 200;
constexpr std::uint32_t kMarkersQueue = 10;
constexpr std::uint32_t kFootprintQueue = 10;

/// The part of an Output that does not depend on the type of its messages.
class OutputTopic {
 public:
  class Subscriber;
  using SubscriberPtr = std::shared_ptr<Subscriber>;
  using OnSubscriber = std::function<void(const SubscriberPtr&)>;

  /// Max bytes that wait for one subscriber. A single larger message is sent when nothing else
  /// waits. If there is no room, the newest message waits until there is, which the thread of
  /// roscpp that writes to sockets notices within 0.1 s. The limit is a second of 80 kB at 100 Hz;
  /// the kernel buffers some more.
  static constexpr std::size_t kMaxBytes = 8'000'000;

  OutputTopic(const OutputTopic&) = delete;
  OutputTopic& operator=(const OutputTopic&) = delete;

  /// Takes no lock.
  bool hasSubscribers() const { return count_ > 0; }

  /// True if a subscriber that may have missed messages has begun to read again since the last
  /// call.
  bool takeLoss() { return has_lost_.exchange(false); }

 protected:
  OutputTopic(ros::NodeHandle& node, ros::AdvertiseOptions options, OnSubscriber on_subscriber);
  ~OutputTopic();

  /// True if the next message must be serialised; else only counts it.
  bool isWanted();
  void send(ros::SerializedMessage message);
  void sendTo(Subscriber& subscriber, const ros::SerializedMessage& message);

 private:
  class Waker;
  using Subscribers = std::vector<SubscriberPtr>;

  void wakeSocketThread();
  void passOn();
  void connect(const ros::SingleSubscriberPublisher& connected);
  void disconnect(const ros::SingleSubscriberPublisher& connected);

  const bool is_latched_;
  const bool has_header_;
  const std::size_t queue_;  ///< messages
  const OnSubscriber on_subscriber_;
  const std::unique_ptr<Waker> waker_;
  /// Of the next message; used by the publishing thread alone. From 1 on, so that a message of
  /// sendTo(), which has 0, is older than all. The header's seq is one less.
  std::uint64_t number_ = 1;
  std::atomic<std::size_t> count_{0};
  std::atomic<bool> has_lost_{false};
  std::mutex mutex_;  ///< of the next three; held for moments only
  std::shared_ptr<const Subscribers> subscribers_ = std::make_shared<Subscribers>();
  ros::SerializedMessage last_;  ///< of a latched topic; empty before the first one
  std::uint64_t last_number_ = 0;
  std::atomic<bool> is_due_{false};  ///< a message is waiting to be passed on
  ros::Publisher publisher_;
  boost::signals2::connection socket_thread_;
};

/// publish() may be called on any thread, by one at a time.
template <class Message>
class Output : public OutputTopic {
 public:
  /// `on_subscriber` is called on the thread of the node handle's queue when somebody has
  /// connected. It may publishTo() the subscriber a message of its own.
  Output(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue,
         OnSubscriber on_subscriber = {})
      : OutputTopic(node, options(topic, queue, false), std::move(on_subscriber)) {}

  struct Latched {};

  /// Each new subscriber gets the last message.
  Output(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue, Latched)
      : OutputTopic(node, options(topic, queue, true), {}) {}

  void publish(const Message& message) {
    if (isWanted()) send(ros::serialization::serializeMessage(message));
  }

  /// Sends to this subscriber alone, unless it has already got a message.
  void publishTo(Subscriber& subscriber, const Message& message) {
    sendTo(subscriber, ros::serialization::serializeMessage(message));
  }

  /// Sends to one subscriber or, if `to` is null, to all.
  void publish(const Message& message, const SubscriberPtr& to) {
    to ? publishTo(*to, message) : publish(message);
  }

 private:
  static ros::AdvertiseOptions options(const std::string& topic, std::uint32_t queue,
                                       bool is_latched) {
    ros::AdvertiseOptions result;
    result.init<Message>(topic, queue);
    result.latch = is_latched;
    return result;
  }
};

}  // namespace link_bounds
