// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The thread of roscpp that writes to sockets gives messages to the connections, which report when
// they have let go of one. On another thread, a connection would ask for a chance to write before
// it notes that it has asked: when it is interrupted in between, the thread of the sockets finds
// nothing to write again and again, for up to a millisecond.
#include "node/outputs/topic/output.h"

#include <poll.h>
#include <ros/poll_manager.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/subscriber_link.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "world/log/guarded.h"

namespace link_bounds {
namespace {

/// The connection of a subscriber. roscpp has no function for it, and the SingleSubscriberPublisher
/// ends with its callback. C++ allows an explicit instantiation to name a private member. ROS 1 is
/// frozen, so the member stays.
ros::SubscriberLinkPtr linkOf(const ros::SingleSubscriberPublisher& subscriber);

template <ros::SubscriberLinkPtr ros::SingleSubscriberPublisher::*member>
struct LinkAccess {
  friend ros::SubscriberLinkPtr linkOf(const ros::SingleSubscriberPublisher& subscriber) {
    return subscriber.*member;
  }
};

template struct LinkAccess<&ros::SingleSubscriberPublisher::link_>;

/// The header's sequence number is the first field of a message, after the message's length.
void writeNumber(std::uint64_t number, ros::SerializedMessage& message) {
  const auto seq = static_cast<std::uint32_t>(number);
  std::memcpy(message.message_start, &seq, sizeof(seq));
}

}  // namespace

/// Wakes the thread of roscpp that writes to sockets. roscpp's own signal does nothing while
/// another thread is signalling: if that thread is interrupted meanwhile, a message waits for up
/// to 0.1 s.
class OutputTopic::Waker {
 public:
  Waker() {
    if (file_->number < 0)
      throw std::system_error(errno, std::generic_category(), "cannot make an eventfd");
    ros::PollSet& sockets = ros::PollManager::instance()->getPollSet();
    sockets.addSocket(file_->number, [file = file_](int) { file->reset(); });
    sockets.addEvents(file_->number, POLLIN);
  }
  ~Waker() { ros::PollManager::instance()->getPollSet().delSocket(file_->number); }
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;

  void wake() const { eventfd_write(file_->number, 1); }

 private:
  /// The thread of the sockets may still call reset() after the end of the waker.
  struct File {
    const int number = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    ~File() { close(number); }
    void reset() const {
      eventfd_t count = 0;
      eventfd_read(number, &count);
    }
  };

  const std::shared_ptr<const File> file_ = std::make_shared<const File>();
};

/// One connection. Two of the same node are two subscribers.
class OutputTopic::Subscriber {
 public:
  Subscriber(ros::SubscriberLinkPtr link, std::size_t max_messages, std::atomic<bool>& has_lost)
      : link_(std::move(link)), max_messages_(max_messages), has_lost_(has_lost) {}

  const ros::SubscriberLinkPtr& link() const { return link_; }

  /// If two threads send at the same time, only the newer message counts.
  void send(const ros::SerializedMessage& message, std::uint64_t number) {
    ros::SerializedMessage replaced;  // is freed without the lock
    const std::lock_guard<std::mutex> lock(mutex_);
    if (number < newest_) return;
    newest_ = number;
    if (pending_.buf) has_missed_ = true;
    std::swap(replaced, pending_);
    pending_ = message;
    queuePending();
  }

  /// Called on the thread of the sockets. False if a message still waits for room.
  bool passOn() {
    std::vector<ros::SerializedMessage> queue;
    bool is_done = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      queuePending();
      std::swap(queue, queue_);
      is_done = !pending_.buf;
    }
    for (const ros::SerializedMessage& message : queue)
      link_->enqueueMessage(message, true, false);
    return is_done;
  }

 private:
  void queuePending() {
    if (!pending_.buf) return;
    const std::size_t waiting = waiting_->bytes;
    if (waiting > 0 && waiting + pending_.num_bytes > kMaxBytes) return;
    if (waiting_->messages >= max_messages_) {
      has_missed_ = true;  // roscpp drops the oldest
    } else if (std::exchange(has_missed_, false)) {
      has_lost_ = true;
    }
    queue_.push_back(link_->isIntraprocess() ? pending_ : counted(pending_));
    pending_ = {};
  }

  /// The same bytes, counted until the last copy of the result is gone. A subscriber in this
  /// process may keep the last message for as long as it lives.
  ros::SerializedMessage counted(const ros::SerializedMessage& message) const {
    const std::size_t size = message.num_bytes;
    waiting_->bytes += size;
    ++waiting_->messages;
    const auto let_go = [bytes = message.buf, waiting = waiting_, size](const std::uint8_t*) {
      waiting->bytes -= size;
      --waiting->messages;
    };
    return {boost::shared_array<std::uint8_t>(message.buf.get(), let_go), size};
  }

  /// Messages that roscpp has not passed on to the kernel.
  struct Waiting {
    std::atomic<std::size_t> bytes{0};
    std::atomic<std::size_t> messages{0};
  };

  const ros::SubscriberLinkPtr link_;
  const std::size_t max_messages_;
  std::atomic<bool>& has_lost_;
  const std::shared_ptr<Waiting> waiting_ = std::make_shared<Waiting>();
  std::mutex mutex_;  ///< of the next four
  std::vector<ros::SerializedMessage> queue_;
  ros::SerializedMessage pending_;  ///< the newest message, if there was no room for it
  std::uint64_t newest_ = 0;        ///< number of the newest message
  bool has_missed_ = false;         ///< a message was missed, and there was no room since
};

OutputTopic::OutputTopic(ros::NodeHandle& node, ros::AdvertiseOptions options,
                         OnSubscriber on_subscriber)
    : is_latched_(options.latch),
      has_header_(options.has_header),
      queue_(options.queue_size),
      on_subscriber_(std::move(on_subscriber)),
      waker_(std::make_unique<Waker>()) {
  options.connect_cb = [this](const auto& connected) { guarded([&] { connect(connected); }); };
  options.disconnect_cb = [this](const auto& connected) {
    guarded([&] { disconnect(connected); });
  };
  publisher_ = node.advertise(options);
  socket_thread_ = ros::PollManager::instance()->addPollThreadListener(
      [this] { guarded([this] { passOn(); }); });
}

/// No callback runs afterwards.
OutputTopic::~OutputTopic() {
  ros::PollManager::instance()->removePollThreadListener(socket_thread_);
  publisher_.shutdown();
}

bool OutputTopic::isWanted() {
  const bool is_wanted = is_latched_ || hasSubscribers();
  if (!is_wanted) ++number_;
  return is_wanted;
}

void OutputTopic::send(ros::SerializedMessage message) {
  const std::uint64_t number = number_++;
  if (has_header_) writeNumber(number - 1, message);
  ros::SerializedMessage replaced;  // is freed without the lock
  std::shared_ptr<const Subscribers> subscribers;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    subscribers = subscribers_;
    if (is_latched_) {
      replaced = std::exchange(last_, message);
      last_number_ = number;
    }
  }
  for (const SubscriberPtr& subscriber : *subscribers)
    subscriber->send(message, number);
  if (!subscribers->empty()) wakeSocketThread();
}

void OutputTopic::sendTo(Subscriber& subscriber, const ros::SerializedMessage& message) {
  subscriber.send(message, 0);
  wakeSocketThread();
}

void OutputTopic::wakeSocketThread() {
  is_due_ = true;
  waker_->wake();
}

void OutputTopic::passOn() {
  if (!is_due_.exchange(false)) return;
  std::shared_ptr<const Subscribers> subscribers;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    subscribers = subscribers_;
  }
  for (const SubscriberPtr& subscriber : *subscribers)
    if (!subscriber->passOn()) is_due_ = true;
}

/// A message that is published meanwhile either finds the subscriber in the list or is `last_`
/// here.
void OutputTopic::connect(const ros::SingleSubscriberPublisher& connected) {
  const auto subscriber = std::make_shared<Subscriber>(linkOf(connected), queue_, has_lost_);
  ros::SerializedMessage last;
  std::uint64_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto subscribers = std::make_shared<Subscribers>(*subscribers_);
    subscribers->push_back(subscriber);
    count_ = subscribers->size();
    subscribers_ = std::move(subscribers);
    last = last_;
    number = last_number_;
  }
  if (last.buf) {
    subscriber->send(last, number);
    wakeSocketThread();
  }
  if (on_subscriber_) on_subscriber_(subscriber);
}

void OutputTopic::disconnect(const ros::SingleSubscriberPublisher& connected) {
  const ros::SubscriberLinkPtr link = linkOf(connected);
  std::shared_ptr<const Subscribers> replaced;  // is freed without the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  auto subscribers = std::make_shared<Subscribers>(*subscribers_);
  const auto gone = std::remove_if(subscribers->begin(), subscribers->end(),
                                   [&](const auto& entry) { return entry->link() == link; });
  subscribers->erase(gone, subscribers->end());
  count_ = subscribers->size();
  replaced = std::exchange(subscribers_, std::move(subscribers));
}

}  // namespace link_bounds
