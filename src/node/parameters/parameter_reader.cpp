// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Conversions of single values.
#include "node/parameters/parameter_reader.h"

namespace link_bounds {

using XmlRpc::XmlRpcValue;

std::string fromXml(XmlRpcValue& value, std::string& out) {
  if (value.getType() != XmlRpcValue::TypeString) return "a string";
  out = static_cast<std::string&>(value);
  return "";
}

std::string fromXml(XmlRpcValue& value, bool& out) {
  if (value.getType() != XmlRpcValue::TypeBoolean) return "true or false";
  out = static_cast<bool&>(value);
  return "";
}

std::string fromXml(XmlRpcValue& value, int& out) {
  if (value.getType() != XmlRpcValue::TypeInt) return "a whole number";
  out = static_cast<int&>(value);
  return "";
}

std::string fromXml(XmlRpcValue& value, double& out) {
  if (value.getType() == XmlRpcValue::TypeInt) {
    out = static_cast<int&>(value);
  } else if (value.getType() == XmlRpcValue::TypeDouble) {
    out = static_cast<double&>(value);
  } else {
    return "a number";
  }
  return "";
}

std::string fromXml(XmlRpcValue& value, std::vector<std::string>& out) {
  constexpr const char* kExpected = "a list of strings";
  if (value.getType() != XmlRpcValue::TypeArray) return kExpected;
  out.assign(static_cast<std::size_t>(value.size()), "");
  for (int i = 0; i < value.size(); ++i) {
    if (!fromXml(value[i], out[static_cast<std::size_t>(i)]).empty()) return kExpected;
  }
  return "";
}

std::vector<std::string> ParameterReader::unknownNames() const {
  std::vector<std::string> result;
  if (values_.getType() != XmlRpcValue::TypeStruct) return result;
  for (auto& [name, value] : values_) {
    if (!known_.count(name)) result.push_back(name);
  }
  return result;
}

}  // namespace link_bounds
