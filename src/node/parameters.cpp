// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Typed values from the parameter server's untyped ones.
#include "parameters.h"

#include <ros/node_handle.h>
#include <ros/param.h>

#include <set>

#include "parameter_table.h"

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

/// fromXml(value, out) fills `out` or returns what the value should have been. XmlRpcValue gives
/// access to its content only if it is not const, hence the references.
const char* fromXml(XmlRpcValue& value, std::string& out) {
  if (value.getType() != XmlRpcValue::TypeString) return "a string";
  out = static_cast<std::string&>(value);
  return nullptr;
}

const char* fromXml(XmlRpcValue& value, bool& out) {
  if (value.getType() != XmlRpcValue::TypeBoolean) return "true or false";
  out = static_cast<bool&>(value);
  return nullptr;
}

const char* fromXml(XmlRpcValue& value, int& out) {
  if (value.getType() != XmlRpcValue::TypeInt) return "a whole number";
  out = static_cast<int&>(value);
  return nullptr;
}

const char* fromXml(XmlRpcValue& value, double& out) {
  if (value.getType() == XmlRpcValue::TypeInt) {
    out = static_cast<int&>(value);
  } else if (value.getType() == XmlRpcValue::TypeDouble) {
    out = static_cast<double&>(value);
  } else {
    return "a number";
  }
  return nullptr;
}

const char* fromXml(XmlRpcValue& value, std::vector<std::string>& out) {
  constexpr const char* kExpected = "a list of strings";
  if (value.getType() != XmlRpcValue::TypeArray) return kExpected;
  out.assign(static_cast<std::size_t>(value.size()), "");
  for (int i = 0; i < value.size(); ++i) {
    if (fromXml(value[i], out[static_cast<std::size_t>(i)])) return kExpected;
  }
  return nullptr;
}

const char* fromXml(XmlRpcValue& value, std::array<double, 4>& out) {
  constexpr const char* kExpected = "a list of four numbers";
  if (value.getType() != XmlRpcValue::TypeArray || value.size() != 4) return kExpected;
  for (int i = 0; i < 4; ++i) {
    if (fromXml(value[i], out[static_cast<std::size_t>(i)])) return kExpected;
  }
  return nullptr;
}

template <class T>
const char* fromXml(XmlRpcValue& value, std::map<std::string, T>& out) {
  if (value.getType() != XmlRpcValue::TypeStruct) return "a map";
  out.clear();
  for (auto& [key, entry] : value) {
    const char* expected = fromXml(entry, out[key]);
    if (expected) return expected;
  }
  return nullptr;
}

/// Sets every parameter that the struct `values` has; collects the names the table knows.
class Reader {
 public:
  explicit Reader(XmlRpcValue& values) : values_(values) {}

  template <class T, class Rule>
  void operator()(const char* name, T& field, Rule rule, const char*) {
    known_.insert(name);
    if (values_.getType() != XmlRpcValue::TypeStruct || !values_.hasMember(name)) return;
    const char* expected = fromXml(values_[name], field);
    std::string fault = expected ? std::string("must be ") + expected : rule(field);
    if (!fault.empty()) throw ParameterError(std::string("parameter ~") + name + " " + fault);
  }

  std::vector<std::string> unknownNames() const {
    std::vector<std::string> result;
    if (values_.getType() != XmlRpcValue::TypeStruct) return result;
    for (auto& [name, value] : values_) {
      if (!known_.count(name)) result.push_back(name);
    }
    return result;
  }

 private:
  XmlRpcValue& values_;
  std::set<std::string> known_{"diagnostic_period"};
};

/// As robot_state_publisher finds it: in the private namespace, else in those above.
std::string foundTfPrefix(const ros::NodeHandle& private_node) {
  std::string key;
  std::string prefix;
  if (!private_node.searchParam("tf_prefix", key)) return "";
  if (!ros::param::get(key, prefix)) throw ParameterError("parameter " + key + " must be a string");
  return prefix;
}

}  // namespace

ReadParameters readParameters() {
  const ros::NodeHandle private_node("~");
  XmlRpcValue values;
  ros::param::get(private_node.getNamespace(), values);
  ReadParameters result;
  Reader reader(values);
  visitParameters(result.parameters, reader);
  result.parameters.tf_prefix = foundTfPrefix(private_node);
  for (const std::string& name : reader.unknownNames()) {
    result.warnings.push_back("parameter ~" + name + " is unknown and ignored; see --help");
  }
  return result;
}

}  // namespace link_bounds
