// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Answers ~get_boxes on the history thread, one request after the other.
#pragma once

#include <ros/node_handle.h>

#include "link_bounds/GetBoxes.h"
#include "node/history/history_thread.h"

namespace link_bounds {

class BoxService {
 public:
  /// `history` must outlive this, which stops it.
  BoxService(const ros::NodeHandle& private_node, HistoryThread& history);
  ~BoxService() { history_.stop(); }
  BoxService(const BoxService&) = delete;
  BoxService& operator=(const BoxService&) = delete;

 private:
  bool onRequest(GetBoxes::Request& request, GetBoxes::Response& response);
  void answer(const GetBoxes::Request& request, GetBoxes::Response& response);

  HistoryThread& history_;
  ros::ServiceServer server_;
};

}  // namespace link_bounds
