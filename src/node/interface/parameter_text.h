// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The text of types and defaults for --help, and of values for messages.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <array>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace link_bounds {

inline std::string typeName(const std::string&) {
  return "string";
}
inline std::string typeName(double) {
  return "double";
}
inline std::string typeName(int) {
  return "int";
}
inline std::string typeName(bool) {
  return "bool";
}
template <std::size_t count>
std::string typeName(const std::array<double, count>&) {
  return "double[" + std::to_string(count) + "]";
}
inline std::string typeName(const std::vector<std::string>&) {
  return "string[]";
}
inline std::string typeName(const std::map<std::string, double>&) {
  return "map name: double";
}
inline std::string typeName(const std::map<std::string, std::vector<std::string>>&) {
  return "map name: string[]";
}
template <class T>
std::string typeName(const std::optional<T>&) {
  return typeName(T());
}

std::string valueText(const std::string& value);
std::string valueText(bool value);
std::string valueText(int value);
std::string valueText(double value);
/// A value of the parameter server, of any type.
std::string valueText(XmlRpc::XmlRpcValue& value);

template <std::size_t count>
std::string valueText(const std::array<double, count>& value) {
  std::string text;
  for (const double part : value)
    text += (text.empty() ? "[" : ", ") + valueText(part);
  return text + "]";
}
/// Only for defaults, which are empty lists and maps.
template <class T>
std::string valueText(const std::vector<T>&) {
  return "[]";
}
template <class T>
std::string valueText(const std::map<std::string, T>&) {
  return "{}";
}
/// A required parameter has no default.
template <class T>
std::string valueText(const std::optional<T>&) {
  return "(required)";
}

/// A visitor of the table of parameters: prints one row per parameter.
class ParameterRows {
 public:
  explicit ParameterRows(std::ostream& out) : out_(out) {}

  template <class T, class Rule>
  void operator()(const char* name, const T& value, Rule, const char* meaning) {
    out_ << "  " << name << " | " << typeName(value) << " | " << valueText(value) << " | "
         << meaning << "\n";
  }

 private:
  std::ostream& out_;
};

}  // namespace link_bounds
