// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts what arrives from the node, and keeps its newest diagnostics.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace link_bounds {

/// Subscribes to all topics of a node, as consumers do.
class SoakListener {
 public:
  SoakListener(ros::NodeHandle& node, const std::string& publisher);

  std::uint64_t boxes() const { return boxes_; }      ///< messages
  std::uint64_t markers() const { return markers_; }  ///< messages

  /// A value of the newest diagnostics; 0 if it is absent.
  double diagnostic(const std::string& key) const;

  /// The max of this value in all diagnostics so far; 0 if it is absent.
  double largest(const std::string& key) const;

 private:
  void onDiagnostics(const diagnostic_msgs::DiagnosticArray& array);

  std::string publisher_;
  std::atomic<std::uint64_t> boxes_{0};
  std::atomic<std::uint64_t> markers_{0};
  mutable std::mutex mutex_;
  std::map<std::string, std::string> diagnostics_;  ///< guarded by mutex_
  std::map<std::string, double> largest_;           ///< guarded by mutex_
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace link_bounds
