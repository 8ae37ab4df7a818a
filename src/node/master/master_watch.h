// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A thread that keeps the node known to the ROS master, also to one that was restarted.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "node/master/registration.h"
#include "node/threads/worker.h"

namespace link_bounds {

/// Asks the master once a second whether it knows the node. Existing connections work without a
/// master. A restarted master does not know the node: then everything is registered again.
/// Has its own thread, because a call to a master that is gone may take seconds to fail.
class MasterWatch {
 public:
  /// `topic`, by its full name, is that of which hasLeft() speaks.
  explicit MasterWatch(std::string topic = "");
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// Whether the node does not publish the topic any more, as the master says, and has not been
  /// started again. To be asked of each publisher all the time: a new master says so only of those
  /// that it has known. One that lives, and unregistered before its address was known, has not
  /// left. From any thread.
  bool hasLeft(const std::string& node);

 private:
  /// A node that published the topic.
  struct Sender {
    std::string address;      ///< "" while that is not known
    bool is_doubted = false;  ///< the master was lost, and has not known it since
    bool has_left = false;    ///< at the newest tick
    int unasked = 0;          ///< ticks
  };

  bool onTick();
  void poll();
  void beginTick(bool is_master_lost);
  void lookForPublishers(const XmlRpcCall& master);
  void reportLost(const char* reason);
  void reportNameTaken();
  void reportBack();

  const std::string topic_;
  bool is_lost_ = false;
  bool is_name_told_ = false;  ///< that another node has the name, since it was lost
  bool name_is_taken_ = false;
  bool must_register_ = false;
  std::mutex mutex_;  ///< of senders_
  std::map<std::string, Sender> senders_;
  Worker worker_;  ///< last: its thread ends before the rest goes
};

}  // namespace link_bounds
