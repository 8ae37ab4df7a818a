// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the parameter robot_description.
#pragma once

#include <ros/node_handle.h>
#include <ros/time.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <stdexcept>
#include <string>

#include "node/interface/parameter_server.h"

namespace link_bounds {

/// The parameter is not set, or the ROS master does not answer.
class NoDescription : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the parameter from the namespace of the node, or else from the nearest one above it.
/// `server` must outlive this.
class RobotDescription {
 public:
  /// Applies the remappings of `node` as well: a nodelet has remappings of its own.
  RobotDescription(const ParameterServer& server, const ros::NodeHandle& node);

  /// "robot_description", and if it is remapped, also its full name.
  std::string name() const;

  /// The value, of any type. Throws NoDescription.
  XmlRpc::XmlRpcValue read() const;

  /// Warns that the node waits for the parameter, at most once in ten seconds.
  void warnOfWaiting(const std::string& reason);

 private:
  std::string fullName() const;
  bool isRemapped() const;

  const ParameterServer& server_;
  std::string ns_;    ///< namespace of the node
  std::string name_;  ///< after the node's own remapping
  ros::SteadyTime last_warning_;
};

}  // namespace link_bounds
