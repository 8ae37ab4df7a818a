// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Turns the rows of a table into way points, tries to prove that the robot does not collide between
// them, and prints the verdicts as a table, CSV or JSON.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "robot/posed/path_prover.h"
#include "robot/posed/robot_path.h"
#include "robot/threads/row_threads.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/formats/safe_text.h"
#include "tools/formats/table_text.h"
#include "tools/urdf_bounds/path/path_certificate.h"
#include "tools/urdf_bounds/path/path_limits.h"
#include "tools/urdf_bounds/poses/reports.h"
#include "tools/urdf_bounds/request/certificate_head.h"
#include "tools/urdf_bounds/request/input.h"

namespace link_bounds {
namespace {

struct PathSegment {
  std::size_t from;  ///< row, from 1
  std::size_t to;
  SegmentProof proof;
  std::vector<std::pair<std::string, double>> pose;  ///< joints that can be set, at proof.share
};

struct PathTable {
  double clearance = 0;             ///< bodies within this distance collide [m]
  std::vector<std::string> bodies;  ///< names
  std::vector<PathSegment> segments;
  Reasons incomplete;
};

constexpr std::size_t kRowNames = 1;  ///< columns that are aligned left

/// Whether no pose of this segment was measured.
bool isUnknown(const SegmentProof& proof) {
  return !std::isfinite(proof.nearest);
}

Row cellsOf(const PathSegment& segment) {
  const SegmentProof& proof = segment.proof;
  Row row = shortRow(toText(proof.verdict), {proof.clearance, proof.nearest, proof.share});
  if (isUnknown(proof)) row[2] = row[3] = "-";
  row.insert(row.begin() + 1, {std::to_string(segment.from), std::to_string(segment.to)});
  return row;
}

std::string namesOf(const PathTable& table, const SegmentProof& proof) {
  if (isUnknown(proof)) return "";
  return printable(table.bodies[proof.first]) + " and " + printable(table.bodies[proof.second]);
}

void writeTable(const PathTable& table, std::ostream& out) {
  out << "unit: m    bodies collide where they "
      << (table.clearance > 0 ? "are within " + shortestNumber(table.clearance) : "touch")
      << "    at: share of the segment\n\n";
  const Row head{"verdict", "from", "to", "clearance", "nearest", "at"};
  Alignment alignment(kRowNames);
  alignment.fit(head);
  for (const PathSegment& segment : table.segments)
    alignment.fit(cellsOf(segment));
  out << alignment.line(head) << "  nearest bodies\n";
  std::array<std::size_t, 3> counts{};
  for (const PathSegment& segment : table.segments) {
    out << alignment.line(cellsOf(segment)) << "  " << namesOf(table, segment.proof) << '\n';
    ++counts[static_cast<std::size_t>(segment.proof.verdict)];
  }
  out << '\n' << table.segments.size() << (table.segments.size() == 1 ? " segment" : " segments");
  for (std::size_t i = 0; i < counts.size(); ++i)
    out << (i == 0 ? ": " : ", ") << counts[i] << ' ' << toText(static_cast<PathVerdict>(i));
  out << '\n';
  for (const PathSegment& segment : table.segments) {
    if (segment.proof.verdict != PathVerdict::kCollides) continue;
    out << "from row " << segment.from << " to row " << segment.to << ", "
        << namesOf(table, segment.proof) << " collide at " << printable(argumentsOf(segment.pose))
        << '\n';
  }
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const PathTable& table, std::ostream& out) {
  out << "from,to,verdict,clearance,nearest,first,second,at,pose\n";
  for (const PathSegment& segment : table.segments) {
    const SegmentProof& proof = segment.proof;
    out << segment.from << ',' << segment.to << ',' << toText(proof.verdict) << ','
        << exactNumber(proof.clearance) << ',';
    if (isUnknown(proof)) {
      out << ",,,,\n";
      continue;
    }
    out << exactNumber(proof.nearest) << ',' << csvField(table.bodies[proof.first]) << ','
        << csvField(table.bodies[proof.second]) << ',' << exactNumber(proof.share) << ','
        << csvField(argumentsOf(segment.pose)) << '\n';
  }
}

std::string toJson(const PathTable& table, const PathSegment& segment) {
  const SegmentProof& proof = segment.proof;
  std::string text = "{\"from\": " + std::to_string(segment.from) +
                     ", \"to\": " + std::to_string(segment.to) + ", \"verdict\": \"" +
                     toText(proof.verdict) + "\", \"clearance\": " + exactNumber(proof.clearance);
  if (isUnknown(proof))
    return text +
           ", \"nearest\": null, \"first\": null, \"second\": null, \"at\": null, \"pose\": {}}";
  return text + ", \"nearest\": " + exactNumber(proof.nearest) +
         ", \"first\": " + jsonString(table.bodies[proof.first]) +
         ", \"second\": " + jsonString(table.bodies[proof.second]) +
         ", \"at\": " + exactNumber(proof.share) + ", \"pose\": " + jsonPose(segment.pose) + "}";
}

void writeJson(const PathTable& table, std::ostream& out) {
  const auto to_json = [&](const PathSegment& segment) { return toJson(table, segment); };
  out << "{\"segments\": ";
  writeJsonList(table.segments, to_json, out);
  out << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

void write(const PathTable& table, Format format, std::ostream& out) {
  writerFor<TableWriter<PathTable>>(format, writeTable, writeCsv, writeJson)(table, out);
}

std::string rowName(std::size_t row) {
  return "row " + std::to_string(row + 1);
}

void checkRows(const UrdfBoundsOptions& options, const JointTable& table) {
  const std::string& file = *options.poses;
  if (table.rows() < 2) throw UsageError(file + " has one row; a path needs two or more");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!table.faults[row].empty())
      throw UsageError(file + ": " + rowName(row) + " " + table.faults[row] +
                       "; --path needs all of its rows");
    if (row == 0 || table.velocities.size() == 0) continue;
    if (!(table.times[row] > table.times[row - 1]))
      throw UsageError(file + ": the time of " + rowName(row) + " is not after that of " +
                       rowName(row - 1) + "; sort the rows");
  }
}

/// One derivative per joint, 0 for joints without a column; empty if the table has none.
std::vector<double> derivativesOf(const JointTable& table, const JointTable::Numbers& numbers,
                                  std::size_t row, std::size_t joints) {
  if (numbers.size() == 0) return {};
  std::vector<double> result(joints, 0.0);
  for (std::size_t i = 0; i < table.joints.size(); ++i)
    result[table.joints[i]] = numbers(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i));
  return result;
}

std::vector<JointMotion> motionsOf(const UrdfBoundsOptions& options, const JointTable& table,
                                   const JointValues& given) {
  std::vector<WayPoint> points;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    points.push_back({valuesOf(table, row, given),
                      derivativesOf(table, table.velocities, row, given.size()),
                      derivativesOf(table, table.accelerations, row, given.size()),
                      table.times.empty() ? 0 : table.times[row]});
  }
  std::vector<JointMotion> motions;
  for (std::size_t row = 1; row < points.size(); ++row) {
    motions.emplace_back(points[row - 1], points[row]);
    if (!motions.back().isFinite())
      throw UsageError(*options.poses + ": the motion to " + rowName(row) +
                       " is not finite; its numbers are too large");
  }
  return motions;
}

PathBodies bodiesOf(const UrdfBoundsOptions& options, const Robot& robot,
                    const BoundedRobot& bounded, const BoundedRobot& objects) {
  for (const BoundedLink& object : objects.links) {
    const auto has_name = [&](const Link& link) { return link.name == object.name; };
    if (std::any_of(robot.links.begin(), robot.links.end(), has_name))
      throw UsageError(*options.objects + ": object \"" + object.name +
                       "\" has the name of a link; rename it");
  }
  return pathBodies(robot, bounded, objects, Exemptions(readSrdf(options.srdf, robot).pairs));
}

/// The values of the joints that can be set.
std::vector<std::pair<std::string, double>> poseOf(const Robot& simple,
                                                   const std::vector<double>& values) {
  std::vector<std::pair<std::string, double>> pose;
  for (const std::size_t joint : settableJoints(simple))
    pose.emplace_back(simple.joints[joint].name, values[joint]);
  return pose;
}

/// Ends when the budget is used up, or at Ctrl-C.
std::function<bool()> budgetOf(const UrdfBoundsOptions& options) {
  return overAfter(options.budget.value_or(kDefaultBudget));
}

std::vector<SegmentProof> prove(const UrdfBoundsOptions& options, const Robot& simple,
                                const PathBodies& bodies, const std::vector<JointMotion>& motions) {
  PathControl control{budgetOf(options), options.jobs.value_or(coreCount())};
  if (hasTerminal())
    control.progress = [&](std::size_t done) { drawBar(done, motions.size(), "segments"); };
  std::vector<SegmentProof> proofs =
      provePath(simple, bodies, motions, {options.clearance.value_or(0)}, control);
  if (hasTerminal()) eraseBar();
  return proofs;
}

std::size_t countOf(const PathTable& table, PathVerdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(table.segments.begin(), table.segments.end(),
                    [=](const PathSegment& s) { return s.proof.verdict == verdict; }));
}

/// How long the searches took.
void reportTimes(const PathTable& table) {
  std::vector<double> times;
  for (const PathSegment& segment : table.segments)
    times.push_back(segment.proof.seconds * 1e3);
  std::sort(times.begin(), times.end());
  say("a segment took " + shortestNumber(times[times.size() / 2]) + " ms in the middle of " +
      std::to_string(times.size()) + ", " + shortestNumber(times.back()) + " ms at most");
}

}  // namespace

Outcome writePath(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const BoundedRobot& objects, const JointTable& table, const JointValues& given) {
  checkRows(options, table);
  const PathBodies bodies = bodiesOf(options, robot, bounded, objects);
  PathTable result{options.clearance.value_or(0), bodies.names, {}, bodies.incomplete};
  const Robot simple = withSimpleJoints(robot);
  const std::vector<JointMotion> motions = motionsOf(options, table, given);
  std::vector<std::string> problems = overshoots(simple, motions, rowName);
  for (std::string& problem : problems)
    problem.insert(0, *options.poses + ": ");
  tellProblems(options, problems);
  std::ofstream certificate = beginCertificate("path", options, simple);
  const std::vector<SegmentProof> proofs = prove(options, simple, bodies, motions);
  for (std::size_t i = 0; i < proofs.size(); ++i)
    result.segments.push_back(
        {i + 1, i + 2, proofs[i], poseOf(simple, motions[i].at(proofs[i].share))});
  std::size_t uncertified = 0;
  if (options.certificate) {
    uncertified = writePathCertificate(options, simple, bodies, motions, proofs, budgetOf(options),
                                       certificate);
  }
  write(result, options.format, std::cout);
  if (options.verbose) reportTimes(result);
  Outcome outcome;
  outcome.has_finding = countOf(result, PathVerdict::kCollides) > 0;
  outcome.lost_geometry = !result.incomplete.empty();
  if (bodies.pairs.empty()) outcome.open.emplace_back(kNothingCompared);
  outcome.addOpen("incomplete names", result.incomplete.size());
  outcome.addOpen("UNDECIDED segments", countOf(result, PathVerdict::kUndecided));
  outcome.addOpen("SAFE segments that are not in the certificate", uncertified);
  return outcome;
}

}  // namespace link_bounds
