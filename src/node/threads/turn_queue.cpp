// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/threads/turn_queue.h"

#include <boost/make_shared.hpp>
#include <boost/smart_ptr/enable_shared_from_this.hpp>

namespace link_bounds {
namespace {

thread_local TurnQueue::Call* current_call = nullptr;

}  // namespace

/// Wraps the callback that roscpp makes for a service call, and holds the state of the call.
class TurnQueue::Turn : public ros::CallbackInterface, public boost::enable_shared_from_this<Turn> {
 public:
  Turn(ros::CallbackInterfacePtr callback, std::uint64_t owner, TurnQueue& queue)
      : callback_(std::move(callback)), owner_(owner), queue_(queue) {
    call_.arrival = std::chrono::steady_clock::now();
  }

  CallResult call() override {
    current_call = &call_;
    const bool was_long = call_.is_long;
    try {
      return callback_->call();
    } catch (const NextTurn&) {
      if (call_.is_long == was_long) return TryAgain;
    }
    Worker& next = call_.is_long ? queue_.long_ : queue_.short_;
    next.addCallback(shared_from_this(), owner_);
    return Success;
  }

 private:
  ros::CallbackInterfacePtr callback_;
  std::uint64_t owner_;
  TurnQueue& queue_;
  Call call_;
};

TurnQueue::Call& TurnQueue::current() {
  return *current_call;
}

void TurnQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  short_.addCallback(boost::make_shared<Turn>(callback, owner, *this), owner);
}

/// A call moves to long_ once and back to short_ once. So these three steps catch every call: a
/// call that moves during one step is found by the next.
void TurnQueue::removeByID(std::uint64_t owner) {
  short_.removeByID(owner);
  long_.removeByID(owner);
  short_.removeByID(owner);
}

}  // namespace link_bounds
