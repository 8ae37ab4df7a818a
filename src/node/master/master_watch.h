// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A thread that keeps the node known to the ROS master, also to one that was restarted.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace link_bounds {

/// Asks the master once a second. While it is away everything that is connected goes on; to a
/// master that does not know the node all is registered again. On a thread of its own, because a
/// master that is gone may be slow to show it.
class MasterWatch {
 public:
  MasterWatch();
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

 private:
  void run();
  void poll();
  void sayLost(const char* how);
  void sayBack();
  bool ends();

  bool is_lost_ = false;
  bool is_to_register_ = false;
  std::mutex mutex_;
  std::condition_variable end_;
  bool ends_ = false;  ///< guarded by mutex_
  std::thread thread_;
};

}  // namespace link_bounds
