// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Converts the untyped values of the parameter server to the types in the table of parameters.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "world/model/parameters.h"

namespace link_bounds {

/// fromXml(value, out) sets `out` and returns "", or returns the expected type in words.
/// `value` is not const, because a const XmlRpcValue does not give access to its content.
std::string fromXml(XmlRpc::XmlRpcValue& value, std::string& out);
std::string fromXml(XmlRpc::XmlRpcValue& value, bool& out);
std::string fromXml(XmlRpc::XmlRpcValue& value, int& out);
std::string fromXml(XmlRpc::XmlRpcValue& value, double& out);
std::string fromXml(XmlRpc::XmlRpcValue& value, std::vector<std::string>& out);

template <std::size_t count>
std::string fromXml(XmlRpc::XmlRpcValue& value, std::array<double, count>& out) {
  const std::string expected = "a list of " + std::to_string(count) + " numbers";
  if (value.getType() != XmlRpc::XmlRpcValue::TypeArray) return expected;
  if (value.size() != static_cast<int>(count)) return expected;
  for (std::size_t i = 0; i < count; ++i) {
    if (!fromXml(value[static_cast<int>(i)], out[i]).empty()) return expected;
  }
  return "";
}

template <class T>
std::string fromXml(XmlRpc::XmlRpcValue& value, std::optional<T>& out) {
  return fromXml(value, out.emplace());
}

template <class T>
std::string fromXml(XmlRpc::XmlRpcValue& value, std::map<std::string, T>& out) {
  if (value.getType() != XmlRpc::XmlRpcValue::TypeStruct) return "a map";
  out.clear();
  for (auto& [key, entry] : value) {
    std::string expected = fromXml(entry, out[key]);
    if (!expected.empty()) return "a map of which \"" + key + "\" is " + expected;
  }
  return "";
}

/// The error message for a parameter. `fault` says what the value must be or must not be.
std::string wrongValue(const std::string& name, XmlRpc::XmlRpcValue& value,
                       const std::string& fault);

/// A visitor of the table of parameters. For each member of the struct `values` it sets the field
/// of that name. Collects all names of the table.
class ParameterReader {
 public:
  explicit ParameterReader(XmlRpc::XmlRpcValue& values) : values_(values) {}

  /// Throws ParameterError.
  template <class T, class Rule>
  void operator()(const char* name, T& field, Rule rule, const char*) {
    known_.insert(name);
    if (values_.getType() != XmlRpc::XmlRpcValue::TypeStruct || !values_.hasMember(name)) return;
    const std::string expected = fromXml(values_[name], field);
    const std::string fault = expected.empty() ? rule(field) : "must be " + expected;
    if (!fault.empty())
      throw ParameterError(wrongValue("~" + std::string(name), values_[name], fault));
  }

  /// True if the table has that name.
  bool knows(const std::string& name) const { return known_.count(name) > 0; }

  /// One warning per member of `values` whose name is not in the table.
  std::vector<std::string> warnings() const;

 private:
  XmlRpc::XmlRpcValue& values_;
  std::set<std::string> known_;
};

}  // namespace link_bounds
