// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "node/interface/parameter_reader.h"

#include <cstdlib>
#include <limits>

#include "node/interface/parameter_text.h"

namespace link_bounds {

using XmlRpc::XmlRpcValue;

namespace {

/// True for a string that reads as a number, such as 1e-2, which YAML takes for a string.
bool isNumber(XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeString) return false;
  const std::string& text = static_cast<std::string&>(value);
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}

}  // namespace

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
  if (value.getType() == XmlRpcValue::TypeDouble &&
      static_cast<double&>(value) > std::numeric_limits<int>::max())
    return "a whole number of at most 2147483647";
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
    return isNumber(value) ? "a number, and is text: YAML wants a point and a sign in 1.0e-2, and "
                             ".inf; quotes make text"
                           : "a number";
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

/// Explains lists and maps, because roscpp takes _name:=[a, b] on the command line for a string.
std::string wrongValue(const std::string& name, XmlRpcValue& value, const std::string& fault) {
  const bool is_list = fault.find("must be a list") == 0;
  const bool is_text = value.getType() == XmlRpcValue::TypeString;
  std::string message = "parameter " + name + " is " + valueText(value) + ", but " + fault;
  if (is_text && (is_list || fault.find("must be a map") == 0))
    message += std::string("; give ") + (is_list ? "a list, [a, b]," : "a map, {a: b},") +
               " by rosparam, or by <rosparam> in a launch file";
  return message;
}

std::vector<std::string> ParameterReader::warnings() const {
  std::vector<std::string> result;
  if (values_.getType() != XmlRpcValue::TypeStruct) return result;
  for (auto& [name, value] : values_) {
    if (known_.count(name)) continue;
    result.push_back("parameter ~" + name + ", which is " + valueText(value) +
                     ", is unknown and ignored; see --help");
  }
  return result;
}

}  // namespace link_bounds
