// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A service whose requests take turns, see TurnQueue. Defines the max size of a request, the
// deadline of an answer, and the error messages.
#pragma once

#include <ros/node_handle.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "node/inputs/incomplete_messages.h"
#include "node/interface/topics.h"
#include "node/threads/turn_queue.h"
#include "world/log/log_text.h"

namespace link_bounds {

/// The max time from the arrival of a request to its answer.
constexpr std::chrono::seconds kDeadline(10);

/// A request that takes longer than this gives way to the next one. A turn costs roscpp some
/// microseconds.
constexpr std::chrono::milliseconds kLongestTurn(5);

/// The max serialised size. In memory a request takes several times its bytes, because each name is
/// a string.
constexpr std::size_t kMaxRequestBytes = 32 << 20;

constexpr const char* kStopping = "the node is shutting down";
constexpr const char* kTooBusy =
    "there was no time to begin within 10 s, because of other requests or much tf; ask again";

/// Advertises one service, refuses requests that are too large, and queues the others.
template <class Service>
class TurnService {
 public:
  using Request = typename Service::Request;
  using Params = ros::ServiceCallbackHelperCallParams;
  using Response = typename Service::Response;
  /// Throws NextTurn, or an error with the reason why there is no answer. Called on the workers of
  /// the queue.
  using Answer = std::function<void(TurnQueue::Call&, const Params&, Response&)>;

  /// `name` and `queue` must outlive this.
  TurnService(ros::NodeHandle& private_node, const TopicName& name, TurnQueue& queue, Answer answer)
      : name_(name) {
    ros::AdvertiseServiceOptions options;
    options.init<Request, Response>(privateName(name), {});
    options.helper = boost::make_shared<Handler>(queue, std::move(answer));
    options.callback_queue = &queue;
    server_ = private_node.advertiseService(options);
  }

  /// Deserialises the request. Throws if it is too large, with `remedy` in the message, or
  /// incomplete.
  Received<Request> read(const Params& params, const std::string& remedy) {
    if (params.request.num_bytes > kMaxRequestBytes)
      throw std::runtime_error("the request has " + std::to_string(params.request.num_bytes) +
                               " bytes, more than " + std::to_string(kMaxRequestBytes) + "; " +
                               remedy);
    Received<Request> request;
    ros::serialization::deserializeMessage(params.request, request);
    const auto caller = params.connection_header->find("callerid");
    const std::string sender = caller == params.connection_header->end() ? "" : caller->second;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!incomplete_messages_.accept(request, name_.name, sender))
      throw std::runtime_error(std::string("the request is refused: ") + kIncompleteMessage);
    return request;
  }

 private:
  /// Does not deserialise the request; `answer` does that when the turn of the request comes.
  class Handler : public ros::ServiceCallbackHelper {
   public:
    Handler(TurnQueue& queue, Answer answer) : queue_(queue), answer_(std::move(answer)) {}
    bool call(Params& params) override {
      TurnQueue::Call& call = TurnQueue::current();
      Response response;
      try {
        queue_.answer(call, [&] { answer_(call, params, response); });
      } catch (const std::exception& error) {
        response = Response();
        response.message = logText(error.what());
      }
      params.response = ros::serialization::serializeServiceResponse(true, response);
      return true;
    }

   private:
    TurnQueue& queue_;
    Answer answer_;
  };

  const TopicName& name_;
  std::mutex mutex_;
  IncompleteMessages incomplete_messages_;  ///< guarded by mutex_
  ros::ServiceServer server_;
};

}  // namespace link_bounds
