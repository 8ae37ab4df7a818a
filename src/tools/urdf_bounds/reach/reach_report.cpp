// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Until all gaps are as small as --accuracy, --budget is used up, or Ctrl-C.
#include "tools/urdf_bounds/reach/reach_report.h"

#include <algorithm>
#include <iostream>

#include "robot/urdf/joints_above.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"
#include "tools/urdf_bounds/reach/reach_certificate.h"
#include "tools/urdf_bounds/reach/reach_table.h"
#include "tools/urdf_bounds/request/certificate_head.h"

namespace link_bounds {
namespace {

void drawProgress(std::size_t done, std::size_t total, double max_gap) {
  drawBar(done, total, "links, the largest gap is " + shortLength(max_gap) + "\033[K");
}

ReachGoal goalOf(const UrdfBoundsOptions& options) {
  ReachGoal goal{options.accuracy.value_or(kDefaultAccuracy)};
  goal.stop = overAfter(options.budget.value_or(kDefaultBudget));
  if (hasTerminal()) goal.progress = drawProgress;
  return goal;
}

/// Why nothing is proven of a link that has geometry.
std::string whyNone(const Robot& robot, const std::vector<JointRange>& ranges, std::size_t link) {
  const std::vector<std::size_t> unknown = unknownOf(ranges, jointsAbove(robot, link));
  return unknown.empty() ? "its size and pose give no finite box" : missingRanges(robot, unknown);
}

ReachTable tableOf(const Robot& robot, const BoundedRobot& bounded,
                   const std::vector<JointRange>& ranges,
                   const std::vector<std::optional<Reach>>& reaches) {
  ReachTable table;
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    if (reaches[i]) table.links.emplace_back(link.name, *reaches[i]);
    if (!link.isWhole()) {
      table.incomplete.emplace_back(link.name, link.missing);
    } else if (!reaches[i]) {
      table.incomplete.emplace_back(link.name, whyNone(robot, ranges, bounded.indices[i]));
      warn("link \"" + link.name + "\": " + table.incomplete.back().second);
    }
  }
  if (const std::optional<Reach> all = unionOf(reaches)) table.groups.emplace_back("robot", *all);
  addIncompleteGroup(table.incomplete);
  return table;
}

double maxGap(const ReachTable& table) {
  double result = 0;
  for (const auto& [name, reach] : table.links)
    result = std::max(result, reach.maxGap());
  return result;
}

/// Why the gaps are larger than what was asked for.
void warnOfGaps(const ReachTable& table, bool was_stopped) {
  const double max_gap = maxGap(table);
  if (max_gap <= table.accuracy) return;
  warn("the boxes are proven, but a face may be too far out by up to " + shortLength(max_gap) +
       ", more than --accuracy " + shortLength(table.accuracy) + ": " +
       (isInterrupted() ? "interrupted"
        : was_stopped   ? "raise --budget or --accuracy"
                        : "no finer search is made; raise --accuracy"));
}

}  // namespace

Outcome writeReach(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges) {
  std::ofstream certificate = beginCertificate("reach", options, robot);
  const ReachGoal goal = goalOf(options);
  const auto reaches = reachOf(robot, bounded, ranges, goal);
  const bool was_stopped = goal.stop();
  ReachTable table = tableOf(robot, bounded, ranges, reaches);
  if (goal.progress) eraseBar();
  table.frame = robot.links[robot.root].name;
  table.accuracy = goal.accuracy;
  warnOfGaps(table, was_stopped);
  std::size_t uncertified = 0;
  if (options.certificate) {
    uncertified = writeReachCertificate(options, robot, bounded, ranges, reaches,
                                        goalOf(options).stop, certificate);
  }
  if (options.as_markers) {
    writeMarkers(table, std::cout);
  } else {
    write(table, options.format, std::cout);
  }
  Outcome outcome;
  outcome.lost_geometry = std::any_of(bounded.links.begin(), bounded.links.end(),
                                      [](const BoundedLink& link) { return !link.isWhole(); });
  if (table.links.empty()) outcome.open.emplace_back("no link has a box");
  outcome.addOpen("incomplete names", table.incomplete.size());
  outcome.addOpen("links that are not in the certificate", uncertified);
  if (maxGap(table) > table.accuracy) outcome.open.emplace_back("--accuracy was not reached");
  return outcome;
}

}  // namespace link_bounds
