// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The node as a nodelet: in the process of a manager, with the parameters and topics of the
// program.
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <thread>

#include "tools/cloud_filter/cloud_filter_node.h"

namespace link_bounds {

/// Has a thread of its own, so that no other nodelet of the manager waits for a cloud.
class CloudFilterNodelet : public nodelet::Nodelet {
 public:
  ~CloudFilterNodelet() override {
    if (node_) node_->stop();
    if (thread_.joinable()) thread_.join();
  }

 private:
  /// Ignores failures that would end the program, such as a wrong parameter: the manager and other
  /// nodelets go on. The log and /diagnostics report them, and ~reload reads everything again.
  void onInit() override {
    node_ = std::make_unique<CloudFilterNode>(getNodeHandle(), getPrivateNodeHandle(), [] {});
    thread_ = std::thread([this] { node_->spin(); });
  }

  std::unique_ptr<CloudFilterNode> node_;
  std::thread thread_;
};

}  // namespace link_bounds

PLUGINLIB_EXPORT_CLASS(link_bounds::CloudFilterNodelet, nodelet::Nodelet)
