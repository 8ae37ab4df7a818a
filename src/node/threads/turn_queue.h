// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Two lanes for the calls of a service: short calls never wait for long ones, and long ones take
// turns.
#pragma once

#include <ros/callback_queue_interface.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>

#include "node/threads/worker.h"

namespace link_bounds {

/// The callback queue of a service. A call begins on the worker for short calls. If its handler
/// throws NextTurn, the handler is called again later: on the worker that `is_long` of the call
/// then selects, after the other calls that wait there. Before each turn roscpp checks whether the
/// client is still connected, and drops the call if not.
///
/// roscpp sends the answer on the thread of the last turn, and meanwhile holds a lock that the
/// thread of its sockets needs. So a long call should end on the worker for short calls, if the
/// worker for long calls has a lower priority.
class TurnQueue : public ros::CallbackQueueInterface {
 public:
  /// Not derived from std::exception, which roscpp would turn into an answer.
  struct NextTurn {};

  /// One call, from its arrival to its answer.
  struct Call {
    std::chrono::steady_clock::time_point arrival;
    bool is_long = false;         ///< the next turn is on the worker for long calls
    std::shared_ptr<void> state;  ///< state of the handler; freed after the answer was sent
    std::exception_ptr error;     ///< caught by answer() on the worker for long calls

    /// True in the first turn.
    bool isNew() const { return !is_long && !state && !error; }
  };

  /// Both workers must outlive this.
  TurnQueue(Worker& short_calls, Worker& long_calls) : short_(short_calls), long_(long_calls) {}

  /// The call whose turn runs on the calling thread. There must be one.
  static Call& current();

  /// For handlers: calls `make`, which throws NextTurn, or an error if there is no answer. The
  /// error must be sent from the worker for short calls. So the error of a long call is kept and
  /// thrown in one more turn there. If that worker is stopping, the error is thrown at once.
  template <class Make>
  void answer(Call& call, Make&& make) {
    if (call.error) std::rethrow_exception(call.error);
    try {
      make();
    } catch (const std::exception&) {
      if (!call.is_long || short_.isStopping()) throw;
      call.error = std::current_exception();
      call.state.reset();
      call.is_long = false;
      throw NextTurn();
    }
  }

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
  void removeByID(std::uint64_t owner) override;

 private:
  class Turn;

  Worker& short_;
  Worker& long_;
};

}  // namespace link_bounds
