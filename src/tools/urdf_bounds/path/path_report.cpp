// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From rows to way points, and from proofs to a table.
#include "tools/urdf_bounds/path/path_report.h"

#include <algorithm>
#include <iostream>

#include "robot/posed/robot_path.h"
#include "robot/threads/row_threads.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/path/path_certificate.h"
#include "tools/urdf_bounds/path/path_limits.h"
#include "tools/urdf_bounds/path/path_table.h"
#include "tools/urdf_bounds/request/certificate_head.h"
#include "tools/urdf_bounds/request/input.h"

namespace link_bounds {
namespace {

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

/// One value per joint, 0 for those without a column.
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
                    const BoundedRobot& bounded, const PathObjects& objects) {
  for (const BoundedLink& object : objects.bounded.links) {
    const auto has_name = [&](const Link& link) { return link.name == object.name; };
    if (std::any_of(robot.links.begin(), robot.links.end(), has_name))
      throw UsageError(*options.objects + ": object \"" + object.name +
                       "\" has the name of a link; rename it");
  }
  return pathBodies(robot, bounded, objects.bounded,
                    Exemptions(readSrdf(options.srdf, robot).pairs));
}

/// The values of the joints that can be set.
std::vector<std::pair<std::string, double>> poseOf(const Robot& simple,
                                                   const std::vector<double>& values) {
  std::vector<std::pair<std::string, double>> pose;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Joint& joint = simple.joints[i];
    if (hasValue(joint.motion) && !joint.mimic) pose.emplace_back(joint.name, values[i]);
  }
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
                  const PathObjects& objects, const JointTable& table, const JointValues& given) {
  checkRows(options, table);
  const PathBodies bodies = bodiesOf(options, robot, bounded, objects);
  PathTable result{options.clearance.value_or(0), bodies.names, {}, bodies.incomplete};
  const Robot simple = withSimpleJoints(robot);
  const std::vector<JointMotion> motions = motionsOf(options, table, given);
  tellProblems(options, overshoots(*options.poses, simple, motions));
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
  if (bodies.pairs.empty()) outcome.open.emplace_back("no two bodies were compared");
  outcome.addOpen("incomplete names", result.incomplete.size());
  outcome.addOpen("UNDECIDED segments", countOf(result, PathVerdict::kUndecided));
  outcome.addOpen("SAFE segments that are not in the certificate", uncertified);
  return outcome;
}

}  // namespace link_bounds
