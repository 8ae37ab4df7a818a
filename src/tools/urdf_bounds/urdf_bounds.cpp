// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads a URDF file and joint values, and prints boxes, other volumes, distances or proofs.
#include <fstream>
#include <iostream>
#include <set>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "packages/package_path.h"
#include "robot/bounded_robot.h"
#include "robot/mesh/mesh_files.h"
#include "robot/posed/posed_robot.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/options.h"
#include "tools/command_line/robot_names.h"
#include "tools/command_line/terminal.h"
#include "tools/command_line/text_file.h"
#include "tools/urdf_bounds/poses/reports.h"
#include "tools/urdf_bounds/request/input.h"
#include "tools/urdf_bounds/request/objects.h"

namespace link_bounds {

namespace {

/// Throws UsageError if an output would overwrite one of the inputs.
void checkOutputs(const UrdfBoundsOptions& options, const std::vector<std::string>& inputs) {
  checkOutput("--series", options.series.value_or(""), inputs);
  checkOutput("--certificate", options.certificate.value_or(""), inputs);
}

BoundedRobot loadLinks(const Robot& robot, const UrdfBoundsOptions& options) {
  Selection selection = selectionOf(options.geometry);
  selection.triangles =
      options.distances || options.report == Report::kPairs || options.report == Report::kPath;
  const MeshSource source{rosPackages(), folderOf(options.file), progressBar(), {}, isInterrupted};
  BoundedRobot bounded = RobotLoader().load(robot, selection, source);
  for (const std::string& problem : allProblems(bounded))
    warn(problem);
  return bounded;
}

/// Names the links that have only geometry of the other kind, so that no verdict is about them.
void sayLeftOut(const Robot& robot, const UrdfBoundsOptions& options) {
  const std::string note = leftOutNote(robot, selectionOf(options.geometry));
  if (!note.empty()) say("note: " + note + "; --geometry both takes them, too");
}

/// Prints the peak of this program alone; the peak of getrusage includes the process that started
/// it.
void reportPeak() {
  std::ifstream status("/proc/self/status");
  for (std::string entry; status >> entry;) {
    if (entry != "VmHWM:") continue;
    status >> entry;
    return say(entry + " kB of memory at the peak");
  }
}

std::size_t treeBytes(const BoundedRobot& bounded) {
  std::set<const TriangleTree*> trees{nullptr};
  std::size_t total = 0;
  for (const Body& body : bounded.bodies) {
    for (const BodyShape& shape : body.shapes) {
      if (trees.insert(shape.triangles.get()).second) total += bytes(*shape.triangles);
    }
  }
  return total;
}

/// The memory of each mesh file, and the peak of this process.
void reportMemory(const BoundedRobot& bounded) {
  std::size_t total = 0;
  for (const auto& [path, points] : bounded.meshes) {
    say(std::to_string(points->bytes()) + " bytes, " + std::to_string(points->size()) +
        " vertices that can be extreme, " + path);
    total += points->bytes();
  }
  say(std::to_string(total) + " bytes in " + std::to_string(bounded.meshes.size()) + " mesh files");
  if (!bounded.bodies.empty())
    say(std::to_string(treeBytes(bounded)) + " bytes in their triangles");
  reportPeak();
}

/// Boxes alone are printed without a verdict, so they leave no question open; distances may.
Outcome outcomeOf(const Reasons& incomplete, const std::optional<DistanceTable>& distances) {
  Outcome outcome;
  outcome.lost_geometry = !incomplete.empty();
  if (!distances) return outcome;
  if (!distances->has_compared) outcome.open.emplace_back("no two links were compared");
  outcome.addOpen("incomplete names", incomplete.size());
  outcome.addOpen("distances less accurate than " + shortLength(DistanceGoal().accuracy),
                  roughPairs(*distances));
  return outcome;
}

/// All pairs of links whose proven distance is at most `limit` [m].
DistanceTable linkDistances(PosedRobot& posed, const BoundedRobot& bounded, double limit) {
  const PoseDistances found = posed.distances(limit);
  DistanceTable table{limit, {}, {}, posed.hasPairs()};
  for (const LinkPairDistance& pair : found.pairs)
    table.pairs.push_back(
        {bounded.links[pair.first].name, bounded.links[pair.second].name, pair.distance});
  for (const std::size_t link : found.unmeasured)
    table.incomplete.emplace_back(bounded.links[link].name,
                                  "its size and pose give no finite distance");
  return table;
}

/// Boxes and distances of one pose.
Outcome runPose(const UrdfBoundsOptions& options, const Robot& robot) {
  // Before loading the meshes, which takes the longest, so that a wrong name is refused at once.
  const Robot simple = withSimpleJoints(robot);
  const std::vector<double> values = valuesFor(simple, options.joints);
  const std::vector<Eigen::Isometry3d> poses = linkPoses(simple, values);
  const BoundedRobot bounded = loadLinks(robot, options);
  std::optional<DistanceTable> distances;
  if (options.distances) {
    PosedRobot posed(robot, bounded);
    posed.move(values);
    distances = linkDistances(posed, bounded, *options.distances);
  }
  const Reasons incomplete =
      writeReport(options, robot.links[robot.root].name, bounded, poses, distances);
  if (options.verbose) reportMemory(bounded);
  return outcomeOf(incomplete, distances);
}

/// Loads the file of --objects, with bodies; returns no objects without that option.
BoundedRobot loadObjects(const UrdfBoundsOptions& options) {
  if (!options.objects) return {};
  const std::string& file = *options.objects;
  const Robot objects = parseObjects(readText(file, "a file of objects"), file);
  Selection selection;
  selection.triangles = true;
  const MeshSource source{rosPackages(), folderOf(file), progressBar(), {}, isInterrupted};
  checkOutputs(options, meshFiles(objects, source.package_path, source.base_folder));
  BoundedRobot bounded = RobotLoader().load(objects, selection, source);
  nameObjects(bounded);
  for (const std::string& problem : allProblems(bounded))
    warn(file + ": " + problem);
  return bounded;
}

/// Boxes and distances of the rows of a table, or proofs about the motion between them.
Outcome runRows(const UrdfBoundsOptions& options, const Robot& robot) {
  const Robot simple = withSimpleJoints(robot);
  const JointValues given = valuesFor(simple, options.joints, options.demand.strict);
  const JointTable table = readJointTable(options, simple, given);
  catchInterrupts();
  const BoundedRobot bounded = loadLinks(robot, options);
  const Outcome outcome =
      options.report == Report::kPath
          ? writePath(options, robot, bounded, loadObjects(options), table, given)
          : writeRows(options, robot, bounded, table, given);
  if (options.verbose) reportMemory(bounded);
  return outcome;
}

/// Proofs about all poses.
Outcome runProof(const UrdfBoundsOptions& options, const Robot& robot) {
  const std::vector<JointRange> ranges = rangesFor(robot, options.joints, options.has_fixed_base);
  catchInterrupts();
  const BoundedRobot bounded = loadLinks(robot, options);
  const auto writeProof = options.report == Report::kReach ? writeReach : writePairs;
  const Outcome outcome = writeProof(options, robot, bounded, ranges);
  if (options.verbose) reportMemory(bounded);
  return outcome;
}

Robot readRobot(const std::string& file) {
  const std::string text = readText(file, "a URDF");
  try {
    return parseRobot(text);
  } catch (const RobotError& error) {
    throw faultIn(file, error);
  }
}

Outcome runReport(const UrdfBoundsOptions& options, const Robot& robot) {
  try {
    if (options.report == Report::kPose) return runPose(options, robot);
    if (options.report == Report::kRows || options.report == Report::kPath)
      return runRows(options, robot);
    return runProof(options, withSimpleJoints(robot));
  } catch (const JointError& error) {
    throw faultIn(options.file, error);
  }
}

int run(const UrdfBoundsOptions& options) {
  checkOutputs(options, {options.file, options.poses.value_or(""), options.srdf.value_or(""),
                         options.objects.value_or("")});
  const Robot robot = readRobot(options.file);
  for (const std::string& warning : robot.warnings)
    warn(warning);
  checkNames(robot);
  checkOutputs(options, meshFiles(robot, rosPackages(), folderOf(options.file)));
  const bool has_verdict = options.report != Report::kPose || options.distances;
  Outcome outcome = runReport(options, robot);
  if (has_verdict) sayLeftOut(robot, options);
  // A warning may mean that some geometry was left out.
  outcome.lost_geometry = outcome.lost_geometry || !robot.warnings.empty();
  if (has_verdict) outcome.addOpen("warnings of the URDF", robot.warnings.size());
  return finishOutput() ? exitCode(outcome, options.demand) : kUnusable;
}

int runWith(int argc, char** argv) {
  const UrdfBoundsOptions options = parseOptions(argc, argv);
  if (!options.help && !options.version) return run(options);
  std::cout << (options.help ? kUsage : "urdf_bounds " LINK_BOUNDS_VERSION "\n");
  return finishOutput() ? 0 : kUnusable;
}

}  // namespace
}  // namespace link_bounds

int main(int argc, char** argv) {
  return link_bounds::runProgram([&] { return link_bounds::runWith(argc, argv); });
}
