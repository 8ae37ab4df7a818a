// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/cloud_filter/filtered_robot.h"

#include <algorithm>
#include <map>

#include "link_bounds/robot/robot_loader.h"
#include "packages/package_path.h"
#include "world/cloud/scan_poses.h"

namespace link_bounds {
namespace {

Selection selectionOf(const FilterParameters& parameters) {
  Selection selection;
  selection.visual = parameters.geometry != "collision";
  selection.collision = parameters.geometry != "visual";
  selection.links = parameters.links;
  selection.ignore_links = parameters.ignore_links;
  selection.padding = parameters.padding;
  selection.link_padding = parameters.link_padding;
  selection.triangles = true;
  return selection;
}

std::vector<std::string> unknownLinks(const Robot& robot, const FilterParameters& parameters) {
  std::map<std::string, std::string> named;
  for (const std::string& link : parameters.links)
    named.emplace(link, "links");
  for (const std::string& link : parameters.ignore_links)
    named.emplace(link, "ignore_links");
  for (const auto& [link, padding] : parameters.link_padding)
    named.emplace(link, "link_padding");
  std::vector<std::string> warnings;
  for (const auto& [name, parameter] : named) {
    const auto is_it = [&link_name = name](const Link& link) { return link.name == link_name; };
    if (std::any_of(robot.links.begin(), robot.links.end(), is_it)) continue;
    warnings.push_back("parameter ~" + parameter + " names link \"" + name +
                       "\", which the robot description does not have; correct the name");
  }
  return warnings;
}

}  // namespace

FilteredRobot filteredRobot(const std::string& description, const FilterParameters& parameters,
                            const std::function<bool()>& is_cancelled) {
  const Robot robot = parseRobot(description);
  MeshSource source;
  source.package_path = rosPackages();
  source.is_cancelled = is_cancelled;
  RobotLoader loader;
  const BoundedRobot bounded = loader.load(robot, selectionOf(parameters), source);
  FilteredRobot result;
  result.parameters = parameters;
  result.problems = bounded.problems;
  result.problems.insert(result.problems.end(), bounded.body_problems.begin(),
                         bounded.body_problems.end());
  result.warnings = unknownLinks(robot, parameters);
  for (std::size_t i = 0; i < bounded.links.size() && !is_cancelled(); ++i) {
    result.links.push_back(bounded.links[i].name);
    result.grids.push_back(std::make_shared<BodyGrid>(
        BodySurface(bounded.bodies[i]), GridOptions{bounded.links[i].padding, kMaxMotionError}));
  }
  return result;
}

}  // namespace link_bounds
