// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of parameters of assert_box, for the reader and for --help.
#include "tools/assert_box/assert_box_parameters.h"

#include <ros/param.h>
#include <ros/this_node.h>

#include <cmath>
#include <map>
#include <sstream>

#include "node/parameters/parameter_reader.h"
#include "node/parameters/parameter_table.h"
#include "node/parameters/parameter_text.h"

namespace link_bounds {
namespace {

const std::map<std::string, BoxCheck> kChecks{
    {"equal", BoxCheck::kEqual}, {"inside", BoxCheck::kInside}, {"outside", BoxCheck::kOutside}};

std::string nameRule(const std::optional<std::string>& name) {
  return name->empty() ? "must not be empty" : "";
}

std::string cornerRule(const std::optional<std::array<double, 3>>& corner) {
  for (const double coordinate : *corner) {
    if (std::isnan(coordinate)) return "must not hold NaN";
  }
  return "";
}

std::string checkRule(const std::string& check) {
  return kChecks.count(check) ? "" : "must be equal, inside or outside";
}

/// Calls visit(name, value, rule, meaning) for each private parameter.
template <class Parameters, class Visitor>
void visitAssertBoxParameters(Parameters& p, Visitor&& visit) {
  visit("topic", p.topic, rules::any<std::string>,
        "link_bounds/AxisAlignedBoxArray: ~boxes, ~groups or ~parts of a publisher");
  visit("name", p.name, nameRule, "of the box: a link, an object or a group");
  visit("min", p.min, cornerRule,
        "x, y, z in metres, in the frame of the boxes; -.inf (not for equal) = no limit");
  visit("max", p.max, cornerRule, "the same for the other corner, none less than in min");
  visit(
      "check", p.check, checkRule,
      "equal: each of the six coordinates is that of min and max, within tolerance. inside: the "
      "box lies in min to max, grown by tolerance. outside: the box and min to max do not "
      "overlap by more than tolerance. A box that is partly inside is neither inside nor outside");
  visit("tolerance", p.tolerance, rules::notNegative, "metres, >= 0");
  visit("deadline", p.deadline, rules::positive,
        "wall seconds, > 0, until the test has passed or failed");
  visit("hold", p.hold, rules::notNegative,
        "wall seconds, >= 0 and less than deadline, for which the check must stay true without a "
        "break; 0 = once is enough");
}

Eigen::Vector3d cornerOf(const std::optional<std::array<double, 3>>& corner, const char* name) {
  if (!corner) throw ParameterError(std::string("parameter ~") + name + " is required");
  return {(*corner)[0], (*corner)[1], (*corner)[2]};
}

Aabb wantedBox(const AssertBoxParameters& parameters) {
  const Aabb box(cornerOf(parameters.min, "min"), cornerOf(parameters.max, "max"));
  if ((box.min().array() > box.max().array()).any()) {
    throw ParameterError("parameter ~min must not be greater than ~max, in x, y and z: " +
                         boxText(box));
  }
  return box;
}

}  // namespace

BoxAssertion boxAssertion(const AssertBoxParameters& parameters) {
  if (!parameters.name) throw ParameterError("parameter ~name is required");
  BoxAssertion result;
  result.topic = parameters.topic;
  result.name = *parameters.name;
  result.check = parameters.check;
  result.condition = {kChecks.at(parameters.check), wantedBox(parameters), parameters.tolerance};
  const Aabb& box = result.condition.wanted;
  const bool is_finite = box.min().allFinite() && box.max().allFinite();
  if (result.condition.check == BoxCheck::kEqual && !is_finite)
    throw ParameterError("parameters ~min and ~max must be finite where ~check is equal");
  if (parameters.hold >= parameters.deadline)
    throw ParameterError("parameter ~hold must be less than ~deadline");
  result.deadline = parameters.deadline;
  result.hold = parameters.hold;
  return result;
}

BoxAssertion readBoxAssertion() {
  XmlRpc::XmlRpcValue values;
  ros::param::get(ros::this_node::getName(), values);
  AssertBoxParameters parameters;
  ParameterReader reader(values);
  visitAssertBoxParameters(parameters, reader);
  for (const std::string& name : reader.unknownNames())
    throw ParameterError("parameter ~" + name + " is unknown; see --help");
  return boxAssertion(parameters);
}

std::string assertBoxUsage() {
  std::ostringstream text;
  text << "usage, in a .test file:\n"
          "  <test test-name=\"NAME\" pkg=\"link_bounds\" type=\"assert_box\">\n"
          "    <rosparam>{name: palm, min: [-1, -1, 0], max: [1, 1, 2], check: inside}</rosparam>\n"
          "  </test>\n\n"
          "A test for rostest: passes when the box of that name has kept the check. A box that is\n"
          "missing, or named in incomplete, does not keep it, nor does one whose publisher has\n"
          "gone; of several boxes of the name each must keep it. The failure tells the last box.\n"
          "A deadline of about a minute and more needs a time-limit of the <test>.\n\n"
          "Parameters, private (name | type | default | meaning):\n";
  const AssertBoxParameters defaults;
  visitAssertBoxParameters(defaults, ParameterRows(text));
  text << "\nOptions:\n"
          "  --gtest_output=xml:FILE   where the result is written; rostest gives it\n"
          "  --text                    accepted and without effect; rostest gives it, too\n"
          "\nExit status: 0 passed, 1 failed.\n";
  return text.str();
}

}  // namespace link_bounds
