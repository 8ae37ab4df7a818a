// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the parameter server. To roscpp a call that failed is a parameter that is not set.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace link_bounds {

/// The ROS master did not answer within the deadline.
class NoMaster : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A call that fails is repeated for ten seconds; then it throws NoMaster.
class ParameterServer {
 public:
  /// `gives_up` is asked ten times a second while the master does not answer.
  explicit ParameterServer(std::function<bool()> gives_up) : gives_up_(std::move(gives_up)) {}

  /// Nothing if the parameter is not set.
  std::optional<XmlRpc::XmlRpcValue> get(const std::string& name) const;

  /// The full name of a parameter in a namespace or the nearest one above; nothing if it is not
  /// set there. A name that was remapped on the command line is taken so.
  std::optional<std::string> search(const std::string& ns, const std::string& name) const;

 private:
  std::optional<XmlRpc::XmlRpcValue> call(const std::string& method, const std::string& caller,
                                          const std::string& name) const;

  std::function<bool()> gives_up_;
};

}  // namespace link_bounds
