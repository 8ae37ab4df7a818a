// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A thread that keeps the node registered with the ROS master, also after a restart of the master.
#pragma once

#include <string>

#include "node/master/senders.h"
#include "node/threads/worker.h"

namespace link_bounds {

/// Asks the master once a second whether it knows the node. Existing connections work without a
/// master. A restarted master does not know the node; then everything is registered again. Has its
/// own thread, because a call to a dead master may take seconds to fail.
class MasterWatch {
 public:
  /// `topic` is the full name of the topic for hasLeft().
  explicit MasterWatch(std::string topic = "");
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// See Senders::ask(). May be called on any thread.
  bool hasLeft(const std::string& node);

 private:
  bool onTick();
  void poll();
  void reportLost(const char* reason);
  void reportNameTaken();
  void reportBack();

  bool is_lost_ = false;
  bool is_name_told_ = false;  ///< reportNameTaken() has logged, since the node was last registered
  bool name_is_taken_ = false;
  bool must_register_ = false;
  Senders senders_;
  Worker worker_;  ///< last: its thread ends before the other members are destroyed
};

}  // namespace link_bounds
