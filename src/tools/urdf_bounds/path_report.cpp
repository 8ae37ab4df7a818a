// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Segments are shared among threads; each has a prover of its own.
#include "tools/urdf_bounds/path_report.h"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "link_bounds/robot/urdf/overlap_filter.h"
#include "robot/pairs/srdf.h"
#include "robot/posed/row_threads.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/terminal.h"
#include "tools/command_line/text_file.h"
#include "tools/urdf_bounds/path_table.h"
#include "tools/urdf_bounds/srdf_check.h"

namespace link_bounds {
namespace {

/// Between two progress reports, for each thread.
constexpr std::size_t kBlock = 16;

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

std::vector<JointMotion> motionsOf(const JointTable& table, const JointValues& given) {
  std::vector<WayPoint> points;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    points.push_back({valuesOf(table, row, given),
                      derivativesOf(table, table.velocities, row, given.size()),
                      derivativesOf(table, table.accelerations, row, given.size()),
                      table.times.empty() ? 0 : table.times[row]});
  }
  std::vector<JointMotion> motions;
  for (std::size_t row = 1; row < points.size(); ++row)
    motions.emplace_back(points[row - 1], points[row]);
  return motions;
}

/// Which no motion leaves.
std::vector<Limits> rangesOf(const std::vector<JointMotion>& motions) {
  std::vector<Limits> all = motions.front().ranges();
  for (const JointMotion& motion : motions) {
    const std::vector<Limits> ranges = motion.ranges();
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = {std::min(all[i].lower, ranges[i].lower), std::max(all[i].upper, ranges[i].upper)};
  }
  return all;
}

/// Links first, then objects.
struct PathScene {
  std::vector<PathBody> bodies;
  PathProver::Pairs pairs;
  PathTable table;  ///< without segments
};

void addBodies(const BoundedRobot& bounded, const std::vector<std::size_t>& links,
               PathScene& scene) {
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    scene.bodies.push_back({links[i], bounded.bodies[i], link.isWhole()});
    scene.table.bodies.push_back(link.name);
    if (!link.isWhole()) scene.table.incomplete.emplace_back(link.name, link.missing);
  }
}

PathScene sceneOf(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const PathObjects& objects) {
  PathScene scene;
  scene.table.clearance = options.clearance.value_or(0);
  addBodies(bounded, bounded.indices, scene);
  addBodies(objects.bounded, std::vector<std::size_t>(objects.bounded.links.size(), robot.root),
            scene);
  std::vector<DisabledPair> disabled;
  if (options.srdf) disabled = parseSrdf(readText(*options.srdf, "a SRDF"), robot, *options.srdf);
  const Exemptions exempt(disabled);
  for (const BoundedLink& object : objects.bounded.links) {
    const auto has_name = [&](const Link& link) { return link.name == object.name; };
    if (std::any_of(robot.links.begin(), robot.links.end(), has_name))
      throw UsageError(*options.objects + ": object \"" + object.name +
                       "\" has the name of a link; rename it");
  }
  const RigidBodies rigid = rigidBodies(robot);
  const std::size_t links = bounded.links.size();
  for (std::size_t i = 0; i < links; ++i) {
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      const bool is_object = j >= links;
      // A link that never moves is where it is.
      const bool is_pair = is_object ? !areJoined(rigid, bounded.indices[i], robot.root, 0)
                                     : !areJoined(rigid, bounded.indices[i], bounded.indices[j]);
      if (is_pair && !exempt.reasonOf(scene.table.bodies[i], scene.table.bodies[j]))
        scene.pairs.emplace_back(i, j);
    }
  }
  return scene;
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
  const std::chrono::duration<double> budget(options.budget.value_or(kDefaultBudget));
  const auto start = std::chrono::steady_clock::now();
  return [=] { return isInterrupted() || std::chrono::steady_clock::now() - start >= budget; };
}

void prove(const UrdfBoundsOptions& options, const Robot& simple, PathScene& scene,
           const std::vector<JointMotion>& motions) {
  const std::function<bool()> is_over = budgetOf(options);
  const PathGoal goal{scene.table.clearance};
  const std::vector<Limits> ranges = rangesOf(motions);
  const auto jobs = static_cast<unsigned>(
      std::min<std::size_t>(options.jobs.value_or(coreCount()), motions.size()));
  std::vector<PathProver> provers;
  for (unsigned i = 0; i < jobs; ++i)
    provers.emplace_back(simple, scene.bodies, scene.pairs, ranges, goal);
  std::vector<PathSegment>& segments = scene.table.segments;
  segments.resize(motions.size());
  const auto work = [&](unsigned thread, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const SegmentProof proof = provers[thread].prove(motions[i], is_over);
      segments[i] = {i + 1, i + 2, proof, poseOf(simple, motions[i].at(proof.share))};
    }
  };
  for (std::size_t done = 0; done < motions.size();) {
    if (hasTerminal()) drawBar(done, motions.size(), "segments");
    const std::size_t end = std::min(done + jobs * kBlock, motions.size());
    forRows(done, end, jobs, 1, work);
    done = end;
  }
  if (hasTerminal()) eraseBar();
}

std::size_t countOf(const PathTable& table, PathVerdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(table.segments.begin(), table.segments.end(),
                    [=](const PathSegment& s) { return s.proof.verdict == verdict; }));
}

}  // namespace

Outcome writePath(const UrdfBoundsOptions& options, const Robot& robot, const BoundedRobot& bounded,
                  const PathObjects& objects, const JointTable& table, const JointValues& given) {
  checkRows(options, table);
  PathScene scene = sceneOf(options, robot, bounded, objects);
  prove(options, withSimpleJoints(robot), scene, motionsOf(table, given));
  write(scene.table, options.format, std::cout);
  Outcome outcome;
  outcome.has_finding = countOf(scene.table, PathVerdict::kCollides) > 0;
  outcome.lost_geometry = !scene.table.incomplete.empty();
  if (scene.pairs.empty()) outcome.open.emplace_back("no two bodies were compared");
  outcome.addOpen("incomplete names", scene.table.incomplete.size());
  outcome.addOpen("UNDECIDED segments", countOf(scene.table, PathVerdict::kUndecided));
  return outcome;
}

}  // namespace link_bounds
