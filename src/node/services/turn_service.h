// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A service whose requests take turns, see TurnQueue: how large they may be, how long answers may
// take, and what is said if one is refused.
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

namespace link_bounds {

/// From the arrival of a request.
constexpr std::chrono::seconds kDeadline(10);

/// A request that takes longer makes way for the next one after so long. A turn of roscpp costs
/// some microseconds.
constexpr std::chrono::milliseconds kLongestTurn(5);

/// As sent. In memory a request takes several times its bytes, because each name is a string.
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
  /// Fills `response` of the params, or throws NextTurn. Called on the workers of the queue.
  using OnTurn = std::function<void(TurnQueue::Call&, Params&)>;

  /// `name` and `queue` must outlive this.
  TurnService(ros::NodeHandle& private_node, const TopicName& name, TurnQueue& queue,
              OnTurn on_turn)
      : name_(name) {
    ros::AdvertiseServiceOptions options;
    options.init<Request, typename Service::Response>(privateName(name), {});
    options.helper = boost::make_shared<Handler>(std::move(on_turn));
    options.callback_queue = &queue;
    server_ = private_node.advertiseService(options);
  }

  /// The request. Throws why it is not read: if it is too large, with that remedy, or announces
  /// more than it has.
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
  /// The request is read when its turn comes.
  class Handler : public ros::ServiceCallbackHelper {
   public:
    explicit Handler(OnTurn on_turn) : on_turn_(std::move(on_turn)) {}
    bool call(Params& params) override {
      on_turn_(TurnQueue::current(), params);
      return true;
    }

   private:
    OnTurn on_turn_;
  };

  const TopicName& name_;
  std::mutex mutex_;
  IncompleteMessages incomplete_messages_;  ///< guarded by mutex_
  ros::ServiceServer server_;
};

}  // namespace link_bounds
