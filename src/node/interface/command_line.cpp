// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Arguments have the forms of roscpp: _PARAMETER:=VALUE, __KEYWORD:=VALUE and NAME:=OTHER_NAME.
#include "node/interface/command_line.h"

#include <ros/names.h>

#include <algorithm>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <set>

#include "node/interface/parameter_table.h"
#include "node/interface/topics.h"
#include "node/interface/usage.h"

namespace link_bounds {
namespace {

using XmlRpc::XmlRpcValue;

const std::set<std::string> kKeywords{"__name", "__ns", "__log", "__ip", "__hostname", "__master"};

/// An argument, split at its first ":=".
struct Assignment {
  std::string argument, left, right;
};

bool isParameter(const std::string& name, const NodeTables& tables) {
  XmlRpcValue none;
  ParameterReader reader(none);
  tables.read_parameters(reader);
  return reader.knows(name);
}

/// True for a topic or a service.
bool isTopic(const std::string& name, const NodeTables& tables) {
  return std::find(tables.topics.begin(), tables.topics.end(), name) != tables.topics.end();
}

/// Services that every roscpp node has.
const std::set<std::string> kLoggers{"~get_loggers", "~set_logger_level"};

bool isName(const std::string& text) {
  std::string reason;
  return ros::names::validate(text, reason);
}

/// The value that roscpp gives to a parameter for this text. roscpp tries the types in the same
/// order.
XmlRpcValue valueOf(const std::string& text) {
  int whole = 0;
  double real = 0;
  if (boost::conversion::try_lexical_convert(text, whole)) return XmlRpcValue(whole);
  if (boost::conversion::try_lexical_convert(text, real)) return XmlRpcValue(real);
  if (text == "true" || text == "True" || text == "TRUE") return XmlRpcValue(true);
  if (text == "false" || text == "False" || text == "FALSE") return XmlRpcValue(false);
  return XmlRpcValue(text);
}

[[noreturn]] void refuse(const std::string& argument, const std::string& remedy) {
  throw ArgumentError("argument \"" + argument + "\" " + remedy);
}

void checkKeyword(const Assignment& a) {
  if (!kKeywords.count(a.left)) {
    refuse(a.argument, "is unknown; roscpp has __name, __ns, __log, __ip, __hostname and __master");
  }
  const bool is_node_name = isName(a.right) && a.right.find_first_of("/~") == std::string::npos;
  if (a.left == "__name" && !is_node_name) {
    refuse(a.argument,
           "is no name of a node: it has letters, digits and _ only; write a namespace "
           "as __ns:=NAMESPACE");
  }
  if (a.left == "__ns" && !isName(a.right)) {
    refuse(a.argument, "is no namespace: it has letters, digits, _ and / only");
  }
}

/// Launch files remap names for all nodes of a scope, so an unused name is no error.
void checkRemapping(const Assignment& a, const NodeTables& tables, CommandLine& line) {
  const bool has_tilde = a.left[0] == '~';
  // roscpp treats ~NAME and ~/NAME alike.
  const std::string name = a.left.substr(!has_tilde ? 0 : a.left.compare(0, 2, "~/") == 0 ? 2 : 1);
  const std::string resolved = has_tilde ? "~" + name : name;
  const bool is_topic = isTopic(resolved, tables) || kLoggers.count(resolved) > 0;
  const bool is_other = !is_topic && isTopic(has_tilde ? name : "~" + name, tables);
  const bool is_parameter = !is_topic && isParameter(name, tables);
  const std::string hint = "to set the parameter, write _" + name + ":=" + a.right;
  if (!isName(a.left) || !isName(a.right)) {
    refuse(a.argument, "is a remapping, but \"" + (isName(a.left) ? a.right : a.left) +
                           "\" is no name of ROS; " +
                           (is_parameter ? hint : "names have letters, digits, _ and / only"));
  }
  if (is_topic || !(has_tilde || is_parameter || is_other)) return;
  const std::string remedy = is_other ? "to remap the one that it has, write " +
                                            (has_tilde ? name : "~" + name) + ":=" + a.right
                             : is_parameter ? hint
                                            : "see --help";
  line.warnings.push_back("argument \"" + a.argument +
                          "\" has no effect: it remaps a topic or service of that name, which the "
                          "node does not have; " +
                          remedy);
}

}  // namespace

NodeTables publisherTables() {
  NodeTables tables;
  tables.read_parameters = [](ParameterReader& reader) {
    Parameters ignored;
    visitParameters(ignored, reader);
  };
  for (const TopicName& topic : kTopics)
    tables.topics.emplace_back(topic.name);
  for (const TopicName& service : kServices)
    tables.topics.emplace_back(service.name);
  return tables;
}

std::string usage() {
  const Parameters defaults;
  return "usage: rosrun link_bounds link_bounds_publisher [_PARAMETER:=VALUE ...] [--help] "
         "[--version]\n\n"
         "_PARAMETER:=VALUE sets strings, numbers, true and false. Set lists and maps by rosparam\n"
         "or in a launch file.\n\n"
         "Publishes the exact axis-aligned bounding box of every link of the robot, in one fixed\n"
         "frame, at each tf update.\n\n" +
         interfaceTables(kTopics, kServices, [&](auto& rows) { visitParameters(defaults, rows); });
}

CommandLine readCommandLine(int argc, const char* const* argv, const NodeTables& tables) {
  CommandLine line;
  XmlRpcValue values;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t sign = argument.find(":=");
    if (argument == "--help" || argument == "-h") {
      line.help = true;
    } else if (argument == "--version") {
      line.version = true;
    } else if (sign == std::string::npos || sign == 0) {
      refuse(argument, "is unknown; write parameters as _NAME:=VALUE, or see --help");
    } else {
      const Assignment a{argument, argument.substr(0, sign), argument.substr(sign + 2)};
      if (a.left.compare(0, 2, "__") == 0) {
        checkKeyword(a);
      } else if (a.left.compare(0, 1, "_") != 0) {
        checkRemapping(a, tables, line);
      } else if (isName("~" + a.left.substr(1))) {
        values[a.left.substr(1)] = valueOf(a.right);
      } else {
        refuse(argument, "names no parameter: a name has letters, digits, _ and / only");
      }
    }
  }
  // Checks the values now: roscpp sets parameters before the node reads them, so a bad value would
  // stay on the server.
  ParameterReader reader(values);
  tables.read_parameters(reader);
  return line;
}

}  // namespace link_bounds
