// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints values in YAML notation.
#include "node/interface/parameter_text.h"

#include <cmath>
#include <sstream>

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

std::string listText(XmlRpcValue& value) {
  std::string text;
  for (int i = 0; i < value.size(); ++i)
    text += (i == 0 ? "" : ", ") + valueText(value[i]);
  return "[" + text + "]";
}

std::string mapText(XmlRpcValue& value) {
  std::string text;
  for (auto& [key, entry] : value)
    text += (text.empty() ? "" : ", ") + key + ": " + valueText(entry);
  return "{" + text + "}";
}

}  // namespace

std::string valueText(const std::string& value) {
  return '"' + value + '"';
}

std::string valueText(bool value) {
  return value ? "true" : "false";
}

std::string valueText(int value) {
  return std::to_string(value);
}

std::string valueText(double value) {
  std::ostringstream stream;
  stream << value;
  const std::string text = stream.str();
  if (!std::isfinite(value)) return text;
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string valueText(XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return valueText(static_cast<bool&>(value));
    case XmlRpcValue::TypeInt:
      return valueText(static_cast<int&>(value));
    case XmlRpcValue::TypeDouble:
      return valueText(static_cast<double&>(value));
    case XmlRpcValue::TypeString:
      return valueText(static_cast<std::string&>(value));
    case XmlRpcValue::TypeArray:
      return listText(value);
    case XmlRpcValue::TypeStruct:
      return mapText(value);
    default:
      return "of another type";
  }
}

}  // namespace link_bounds
