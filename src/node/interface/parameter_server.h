// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the parameter server. roscpp's own functions do not tell a failed call from a parameter
// that is not set.
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
  /// `is_cancelled` is called ten times a second while the master does not answer. If it returns
  /// true, the call ends with NoMaster.
  explicit ParameterServer(std::function<bool()> is_cancelled)
      : is_cancelled_(std::move(is_cancelled)) {}

  /// The value; nullopt if the parameter is not set.
  std::optional<XmlRpc::XmlRpcValue> get(const std::string& name) const;

  /// The full name: `name` after remappings of the command line, relative to `ns`.
  static std::string resolved(const std::string& ns, const std::string& name);

  /// The full name of the parameter if it is set in `ns` or in a namespace above it, nearest first;
  /// nullopt if there is none. Remappings of `name` on the command line apply.
  std::optional<std::string> search(const std::string& ns, const std::string& name) const;

 private:
  std::optional<XmlRpc::XmlRpcValue> call(const std::string& method, const std::string& caller,
                                          const std::string& name) const;

  std::function<bool()> is_cancelled_;
};

}  // namespace link_bounds
