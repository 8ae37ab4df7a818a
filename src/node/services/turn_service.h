// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A service whose requests take turns, see TurnQueue.
#pragma once

#include <ros/node_handle.h>

#include <boost/make_shared.hpp>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "node/inputs/incomplete_messages.h"
#include "node/interface/topics.h"
#include "node/services/request_limits.h"
#include "node/threads/turn_queue.h"

namespace link_bounds {

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
