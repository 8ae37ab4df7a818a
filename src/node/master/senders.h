// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which publishers of a topic no longer publish it, according to a ROS master that may be lost and
// replaced.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "node/master/registration.h"

namespace link_bounds {

/// Keeps the nodes for which ask() was called. May be used on any thread.
class Senders {
 public:
  struct Answer {
    bool has_left;
    bool is_new;  ///< this is the first ask() for the node, so has_left is not known yet
  };

  explicit Senders(std::string topic) : topic_(std::move(topic)) {}

  /// has_left is true if the master says that the node no longer publishes the topic and has not
  /// been started again. Call this regularly, or the node is forgotten. has_left stays false for a
  /// node that a replaced master has not yet listed as a publisher, and for a running node that
  /// unregistered before its address was known.
  Answer ask(const std::string& node);

  /// Call before the master is asked. `is_master_lost`: the master does not answer, or does not
  /// know this node.
  void beginTick(bool is_master_lost);

  /// Asks the master. Without an answer, has_left is false for all nodes.
  void look(const XmlRpcCall& master);

 private:
  /// A node that published the topic at some time.
  struct Sender {
    std::string address;      ///< XML-RPC address; "" while it is not known
    bool is_doubted = false;  ///< no master has listed the node since a master was lost
    bool has_left = false;    ///< result of the newest tick
    int unasked = 0;          ///< ticks since the last ask()
  };

  const std::string topic_;
  std::mutex mutex_;       ///< guards the members below
  bool was_lost_ = false;  ///< the master was lost at least once
  std::map<std::string, Sender> senders_;
};

}  // namespace link_bounds
