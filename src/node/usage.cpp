// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the tables of topics.h and parameter_table.h.
#include "usage.h"

#include <sstream>

#include "parameter_table.h"
#include "topics.h"

namespace link_bounds {
namespace {

const char* typeName(const std::string&) {
  return "string";
}
const char* typeName(double) {
  return "double";
}
const char* typeName(int) {
  return "int";
}
const char* typeName(bool) {
  return "bool";
}
const char* typeName(const std::array<double, 4>&) {
  return "double[4]";
}
const char* typeName(const std::vector<std::string>&) {
  return "string[]";
}
const char* typeName(const std::map<std::string, double>&) {
  return "map link: double";
}
const char* typeName(const std::map<std::string, std::vector<std::string>>&) {
  return "map name: string[]";
}

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
  std::ostringstream text;
  text << value;
  return text.str().find('.') == std::string::npos ? text.str() + ".0" : text.str();
}
std::string valueText(const std::array<double, 4>& value) {
  std::string text;
  for (const double part : value)
    text += (text.empty() ? "[" : ", ") + valueText(part);
  return text + "]";
}
/// The defaults of lists and maps are empty.
template <class T>
std::string valueText(const std::vector<T>&) {
  return "[]";
}
template <class T>
std::string valueText(const std::map<std::string, T>&) {
  return "{}";
}

}  // namespace

std::string usage() {
  std::ostringstream text;
  text << "usage: rosrun link_bounds link_bounds_publisher [_PARAMETER:=VALUE ...]\n\n"
          "Publishes the exact axis-aligned bounding box of every link of the robot, in one fixed\n"
          "frame, at each tf update.\n\nTopics (name | type | when):\n";
  for (const TopicName& topic : kTopics) {
    text << "  " << topic.name << " | " << topic.type << " | " << topic.when << "\n";
  }
  text << "\nServices (name | type | what):\n  " << kReloadService.name << " | "
       << kReloadService.type << " | " << kReloadService.when << "\n";
  text << "\nParameters, private unless said (name | type | default | meaning):\n"
          "  robot_description | string | (public, found upwards) | the URDF; waited for while "
          "absent\n";
  const Parameters defaults;
  visitParameters(defaults,
                  [&text](const char* name, const auto& value, auto, const char* meaning) {
                    text << "  " << name << " | " << typeName(value) << " | " << valueText(value)
                         << " | " << meaning << "\n";
                  });
  return text.str();
}

}  // namespace link_bounds
