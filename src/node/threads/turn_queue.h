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

/// The callback queue of a service. A call begins on the worker for short calls. Where its handler
/// throws NextTurn, it is called again, after the others that wait there, on the worker that
/// `is_long` of the call says then; and so on. Before each turn roscpp looks whether the client is
/// still there, and drops the call if it is gone.
///
/// roscpp sends an answer on the thread of the last turn, and holds a lock for which the thread of
/// its sockets waits. So a call that was long should end on the worker for short calls, if the
/// other one has a lower priority.
class TurnQueue : public ros::CallbackQueueInterface {
 public:
  /// No std::exception, of which roscpp would make an answer.
  struct NextTurn {};

  /// One call, from its arrival to its answer.
  struct Call {
    std::chrono::steady_clock::time_point arrival;
    bool is_long = false;         ///< its next turn is on the worker for long calls
    std::shared_ptr<void> state;  ///< what the handler keeps; is freed after the answer was sent
    std::exception_ptr error;     ///< that answer() caught on the worker for long calls

    /// Whether this is its first turn.
    bool isNew() const { return !is_long && !state && !error; }
  };

  /// Both workers must live longer.
  TurnQueue(Worker& short_calls, Worker& long_calls) : short_(short_calls), long_(long_calls) {}

  /// The call that runs on the calling thread. There must be one.
  static Call& current();

  /// For handlers: calls `make`, which throws NextTurn, or why there is no answer. Throws that
  /// reason on the worker for short calls, to be sent from there: in a further turn if the call is
  /// long. If that worker is stopping, throws it at once.
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
