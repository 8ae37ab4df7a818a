// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which publishers of a topic have left, as a ROS master says that may be lost and replaced.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "node/master/registration.h"

namespace link_bounds {

/// Those that are asked about. From any thread.
class Senders {
 public:
  struct Answer {
    bool has_left;
    bool is_new;  ///< it is asked about for the first time, so has_left is not known yet
  };

  explicit Senders(std::string topic) : topic_(std::move(topic)) {}

  /// Whether the node does not publish the topic any more, as the master says, and has not been
  /// started again. To be asked all the time: a master says so only of those that it has known, and
  /// not of one that lives and unregistered before its address was known.
  Answer ask(const std::string& node);

  /// Before the master is asked. `is_master_lost`: it does not answer, or does not know this node.
  void beginTick(bool is_master_lost);

  /// Asks the master. Of none is said that it has left if there is no answer.
  void look(const XmlRpcCall& master);

 private:
  /// A node that published the topic.
  struct Sender {
    std::string address;      ///< "" while that is not known
    bool is_doubted = false;  ///< no master has said, since one was lost, that it publishes
    bool has_left = false;    ///< at the newest tick
    int unasked = 0;          ///< ticks
  };

  const std::string topic_;
  std::mutex mutex_;       ///< of the following
  bool was_lost_ = false;  ///< the master, ever
  std::map<std::string, Sender> senders_;
};

}  // namespace link_bounds
