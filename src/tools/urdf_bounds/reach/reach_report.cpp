// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the boxes that links never leave as a table, CSV, JSON or markers, all with the same
// numbers in the same order. The search ends when all gaps are within --accuracy, when --budget is
// used up, or at Ctrl-C.
#include <algorithm>
#include <iostream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "robot/reach/reach.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"
#include "tools/formats/safe_text.h"
#include "tools/formats/table_text.h"
#include "tools/urdf_bounds/poses/reports.h"
#include "tools/urdf_bounds/reach/reach_certificate.h"
#include "tools/urdf_bounds/request/certificate_head.h"

namespace link_bounds {
namespace {

/// All lengths are in metres, all coordinates in `frame`.
struct ReachTable {
  using NamedReach = std::pair<std::string, Reach>;

  std::string frame;
  double accuracy = 0;             ///< as requested by --accuracy
  std::vector<NamedReach> links;   ///< in the order of the URDF
  std::vector<NamedReach> groups;  ///< the robot, if any link has a box
  Reasons incomplete;
};

/// Thin lines for a link and thick ones for the robot: both are visible where they coincide.
constexpr char kThin[] = "{x: 0.005}, color: {r: 0.1, g: 0.7, b: 1.0, a: 0.6}";
constexpr char kThick[] = "{x: 0.015}, color: {r: 1.0, g: 0.5, b: 0.1, a: 1.0}";

Numbers faceNumbers(const Reach& reach) {
  Numbers numbers;
  for (const ReachFace& face : reach.faces)
    numbers.push_back(face.at);
  return numbers;
}

Row rowOf(const std::string& name, const Reach& reach) {
  Numbers numbers = faceNumbers(reach);
  numbers.push_back(reach.maxGap());
  return shortRow(name, numbers);
}

void writeTable(const ReachTable& table, std::ostream& out) {
  out << "frame: " << printable(table.frame)
      << "    unit: m    the links never leave these boxes; gap: a pose is as near to each "
         "face\n\n";
  std::vector<Row> rows{{"link", "min x", "min y", "min z", "max x", "max y", "max z", "gap"}};
  for (const auto& [name, reach] : table.links)
    rows.push_back(rowOf(printable(name), reach));
  for (const auto& [name, reach] : table.groups)
    rows.push_back(rowOf(kGroupPrefix + name, reach));
  writeAligned(rows, out);
  if (table.links.empty()) out << "(" << kNoLinkBounded << ")\n";
  writeIncomplete(table.incomplete, out);
}

void writeReachRow(const std::string& name, const Reach& reach, std::ostream& out) {
  Numbers numbers = faceNumbers(reach);
  for (const ReachFace& face : reach.faces)
    numbers.push_back(face.gap());
  writeCsvRow(name, numbers, out);
}

void writeCsv(const ReachTable& table, std::ostream& out) {
  out << "link,min_x,min_y,min_z,max_x,max_y,max_z,"
         "gap_min_x,gap_min_y,gap_min_z,gap_max_x,gap_max_y,gap_max_z\n";
  for (const auto& [name, reach] : table.links)
    writeReachRow(name, reach, out);
  for (const auto& [name, reach] : table.groups)
    writeReachRow(kGroupPrefix + name, reach, out);
  writeCsvIncomplete(table.incomplete, 2 * kFaces, out);
}

std::string toJson(const Reach& reach) {
  const auto gap = [](const ReachFace& face) { return exactNumber(face.gap()); };
  const auto pose = [](const ReachFace& face) { return jsonPose(face.pose); };
  return "{" + jsonCorners(reach.box()) + ",\n   \"gap\": [" + joined(reach.faces, ", ", gap) +
         "],\n   \"attained\": [" + joined(reach.faces, ",\n    ", pose) + "]}";
}

void writeJson(const ReachTable& table, std::ostream& out) {
  const auto to_json = [](const Reach& reach) { return toJson(reach); };
  out << "{\"frame\": " << jsonString(table.frame)
      << ",\n \"accuracy\": " << exactNumber(table.accuracy)
      << ",\n \"reach\": " << jsonObject(table.links, to_json)
      << ",\n \"groups\": " << jsonObject(table.groups, to_json)
      << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

/// YAML accepts this JSON-like text, also for exact numbers.
std::string pointOf(const Eigen::Vector3d& point) {
  return "{x: " + exactNumber(point.x()) + ", y: " + exactNumber(point.y()) +
         ", z: " + exactNumber(point.z()) + "}";
}

/// The edges of a box, as a marker of type LINE_LIST.
void writeMarker(const ReachTable& table, const std::string& name, const Reach& reach,
                 std::size_t id, const std::string& look, std::ostream& out) {
  const std::array<Eigen::Vector3d, 8> points = corners(reach.box());
  const auto end = [&](int number) { return pointOf(points[static_cast<std::size_t>(number)]); };
  const auto line = [&](const auto& edge) { return joined(edge, ", ", end); };
  out << "- {header: {frame_id: " << jsonString(table.frame) << "}, ns: " << jsonString(name)
      << ", id: " << id << ", type: 5, pose: {orientation: {w: 1}}, scale: " << look
      << ",\n   points: [" << joined(edges(), ", ", line) << "]}\n";
}

void write(const ReachTable& table, Format format, std::ostream& out) {
  writerFor<TableWriter<ReachTable>>(format, writeTable, writeCsv, writeJson)(table, out);
}

/// A visualization_msgs/MarkerArray as YAML: the edges of each box.
void writeMarkers(const ReachTable& table, std::ostream& out) {
  std::size_t id = 0;
  out << (table.links.empty() ? "markers: []\n" : "markers:\n");
  for (const auto& [name, reach] : table.links)
    writeMarker(table, name, reach, id++, kThin, out);
  for (const auto& [name, reach] : table.groups)
    writeMarker(table, name, reach, id++, kThick, out);
  for (const auto& [name, reason] : table.incomplete)
    out << "# incomplete: " << printable(name) << ": " << printable(reason) << '\n';
}

void drawProgress(std::size_t done, std::size_t total, double max_gap) {
  drawBar(done, total, "links, the largest gap is " + shortLength(max_gap) + "\033[K");
}

ReachGoal goalOf(const UrdfBoundsOptions& options) {
  ReachGoal goal{options.accuracy.value_or(kDefaultAccuracy)};
  goal.stop = overAfter(options.budget.value_or(kDefaultBudget));
  if (hasTerminal()) goal.progress = drawProgress;
  return goal;
}

ReachTable tableOf(const Robot& robot, const BoundedRobot& bounded,
                   const std::vector<JointRange>& ranges,
                   const std::vector<std::optional<Reach>>& reaches) {
  ReachTable table;
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    if (reaches[i]) table.links.emplace_back(link.name, *reaches[i]);
    if (reaches[i] && link.isWhole()) continue;
    table.incomplete.emplace_back(link.name, whyNoReach(robot, bounded, ranges, i));
    if (link.isWhole()) warn("link \"" + link.name + "\": " + table.incomplete.back().second);
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

/// Warns of gaps above --accuracy, with the cause.
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
  if (table.links.empty()) outcome.open.emplace_back(kNoLinkBounded);
  outcome.addOpen("incomplete names", table.incomplete.size());
  outcome.addOpen("links that are not in the certificate", uncertified);
  if (maxGap(table) > table.accuracy) outcome.open.emplace_back("--accuracy was not reached");
  return outcome;
}

}  // namespace link_bounds
