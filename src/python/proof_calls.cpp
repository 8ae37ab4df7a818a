// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/proof_calls.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "link_bounds/robot/urdf/kinematics.h"
#include "python/joint_input.h"
#include "python/text.h"
#include "robot/bounded_robot.h"
#include "robot/pairs/srdf.h"
#include "robot/posed/robot_path.h"
#include "robot/threads/row_threads.h"
#include "robot/urdf/limit_warnings.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/outcome.h"
#include "tools/command_line/text_file.h"
#include "tools/urdf_bounds/path/path_limits.h"
#include "tools/urdf_bounds/request/objects.h"

namespace py = pybind11;

namespace link_bounds {
namespace {

std::vector<JointRange> rangesOf(const SharedRobot& shared, const ProofRequest& request) {
  checkPositive("accuracy", request.accuracy, "metres");
  checkPositive("budget", request.budget, "seconds");
  GivenRanges given = givenRanges(shared, request.ranges);
  for (std::size_t i = 0; request.fixed_base && i < shared.robot().joints.size(); ++i) {
    const std::string& name = shared.robot().joints[i].name;
    if (!movesBase(shared.robot(), i)) continue;
    if (!given.emplace(name, Limits{0, 0}).second)
      throw JointError("fixed_base keeps \"" + name + "\" at 0; give only one of the two");
  }
  std::string beyond = beyondLimits(shared.robot(), given);
  if (!beyond.empty()) beyond += "; the proof is about these values all the same";
  for (const std::string& warning : {beyond, equalLimits(shared.robot(), given)}) {
    if (!warning.empty()) warnInPython(warning);
  }
  return jointRanges(shared.robot(), given);
}

void warnOfGap(double max_gap, double accuracy) {
  if (max_gap <= accuracy) return;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "the boxes are proven, but a face may be too far out by up to " << max_gap
       << " m, more than the accuracy " << accuracy << " m: raise budget or accuracy";
  warnInPython(text.str());
}

py::array_t<double> facesOf(const Reach& reach, double (*number)(const ReachFace&)) {
  py::array_t<double> result(std::vector<Py_ssize_t>{2, 3});
  for (std::size_t face = 0; face < kFaces; ++face)
    result.mutable_data()[face] = number(reach.faces[face]);
  return result;
}

/// Poses, or their derivatives: one row per way point.
JointRows rowsOf(const SharedRobot& shared, const py::object& given, const char* name) {
  JointRows rows = jointRows(shared, given, name);
  if (rows.is_single || rows.count < 2)
    throw py::value_error(std::string(name) + " has " + (rows.count == 0 ? "no" : "one") +
                          " row; a path needs two or more, as an array [rows, joints] or a "
                          "list of dicts");
  return rows;
}

std::optional<JointRows> optionalRows(const SharedRobot& shared, const py::object& given,
                                      const char* name, std::size_t count) {
  if (given.is_none()) return std::nullopt;
  JointRows rows = rowsOf(shared, given, name);
  if (rows.count != count)
    throw py::value_error(std::string(name) + " has " + std::to_string(rows.count) +
                          " rows, but q has " + std::to_string(count));
  return rows;
}

std::vector<double> timesOf(const py::object& given, std::size_t count) {
  if (given.is_none()) return {};
  const RowArray times(numbersOf(given, "times", " must be an array [rows] of seconds"));
  if (times.ndim() != 1 || times.shape(0) != static_cast<Py_ssize_t>(count))
    throw py::value_error("times must be an array [rows] of " + std::to_string(count) + " numbers");
  std::vector<double> result(times.data(), times.data() + count);
  for (std::size_t row = 0; row < count; ++row) {
    const bool is_right = std::isfinite(result[row]) && (row == 0 || result[row] > result[row - 1]);
    if (!is_right)
      throw py::value_error("times[" + std::to_string(row) +
                            "] is not a finite number above the one before; times must grow");
  }
  return result;
}

std::vector<JointMotion> motionsOf(const SharedRobot& shared, const PathRequest& request) {
  const JointRows poses = rowsOf(shared, request.poses, "q");
  const auto velocities = optionalRows(shared, request.velocities, "velocities", poses.count);
  const auto speeding = optionalRows(shared, request.accelerations, "accelerations", poses.count);
  const std::vector<double> times = timesOf(request.times, poses.count);
  if (velocities && times.empty()) throw py::value_error("velocities need times; give both");
  if (speeding && !velocities)
    throw py::value_error("accelerations need velocities and times; give all three");
  std::vector<WayPoint> points;
  for (std::size_t row = 0; row < poses.count; ++row) {
    points.push_back({spread(shared, poses, row),
                      velocities ? spread(shared, *velocities, row) : std::vector<double>(),
                      speeding ? spread(shared, *speeding, row) : std::vector<double>(),
                      times.empty() ? 0 : times[row]});
  }
  std::vector<JointMotion> motions;
  for (std::size_t row = 1; row < points.size(); ++row) {
    motions.emplace_back(points[row - 1], points[row]);
    if (!motions.back().isFinite())
      throw py::value_error("the motion to q[" + std::to_string(row) +
                            "] is not finite; its numbers are too large");
  }
  return motions;
}

void warnOfLimits(const SharedRobot& shared, const std::vector<JointMotion>& motions) {
  const auto row_name = [](std::size_t row) { return "q[" + std::to_string(row) + "]"; };
  for (const auto& search : {rowsBeyond, overshoots}) {
    for (const std::string& warning : search(shared.robot(), motions, row_name))
      warnInPython(warning);
  }
}

std::string pathOf(const py::object& file) {
  return py::cast<std::string>(py::module::import("os").attr("fsencode")(file));
}

/// Throws RobotError for a mesh that cannot be used, unless the robot may be incomplete.
BoundedRobot objectsOf(const SharedRobot& shared, const py::object& given) {
  if (given.is_none()) return {};
  const std::string file = pathOf(given);
  const Robot objects = parseObjects(textOfFile(file, "a file of objects"), file);
  for (const Link& object : objects.links) {
    const auto has_name = [&](const Link& link) { return link.name == object.name; };
    const std::vector<Link>& links = shared.robot().links;
    if (std::any_of(links.begin(), links.end(), has_name))
      throw py::value_error(file + ": object \"" + object.name +
                            "\" has the name of a link; rename it");
  }
  BoundedRobot loaded = interruptible(
      [&](const StopFlag& stop) { return shared.loadObjects(objects, folderOf(file), stop); });
  for (const std::string& problem : allProblems(loaded))
    warnInPython(file + ": " + problem);
  return loaded;
}

std::map<std::string, double> poseOf(const SharedRobot& shared, const std::vector<double>& values) {
  std::map<std::string, double> pose;
  for (const std::size_t joint : shared.joints())
    pose.emplace(shared.robot().joints[joint].name, values[joint]);
  return pose;
}

}  // namespace

py::array boxOf(const Reach& reach) {
  return facesOf(reach, [](const ReachFace& face) { return face.at; });
}

py::array gapOf(const Reach& reach) {
  return facesOf(reach, [](const ReachFace& face) { return face.gap(); });
}

py::dict reachOfRobot(const SharedRobot& shared, const ProofRequest& request) {
  const std::vector<JointRange> ranges = rangesOf(shared, request);
  shared.warnOfLeftOut();
  const auto reaches = interruptible([&](const StopFlag& stop) {
    ReachGoal goal{request.accuracy};
    goal.stop = overAfter(request.budget, [&stop] { return stop.load(); });
    return reachOf(shared.robot(), shared.bounded(), ranges, goal);
  });
  py::dict result;
  double max_gap = 0;
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const std::string& name = shared.bounded().links[i].name;
    if (reaches[i]) {
      result[toPython(name)] = py::cast(*reaches[i]);
      max_gap = std::max(max_gap, reaches[i]->maxGap());
    } else {
      warnInPython("link \"" + name +
                   "\": " + whyNoReach(shared.robot(), shared.bounded(), ranges, i));
    }
  }
  if (result.empty()) warnInPython(kNoLinkBounded);
  warnOfGap(max_gap, request.accuracy);
  return result;
}

bool isAdjacent(const PairProof& proof) {
  return proof.verdict == Verdict::kAdjacent;
}

std::vector<NamedProof> pairsOfRobot(const SharedRobot& shared, const ProofRequest& request,
                                     double clearance, double touching, bool adjacent,
                                     unsigned jobs) {
  checkLength("clearance", clearance);
  checkLength("touching", touching);
  checkJobs(jobs);
  const std::vector<JointRange> ranges = rangesOf(shared, request);
  shared.warnOfLeftOut();
  const std::vector<PairProof> proofs = interruptible([&](const StopFlag& stop) {
    ProofControl control;
    control.is_over = overAfter(request.budget, [&stop] { return stop.load(); });
    control.threads = jobs;
    const PairGoal goal{clearance, request.accuracy, touching};
    return provePairs(shared.robot(), shared.bounded(), ranges, goal, control, {adjacent, false});
  });
  if (std::all_of(proofs.begin(), proofs.end(), isAdjacent)) warnInPython(kNoPairExamined);
  const std::vector<BoundedLink>& links = shared.bounded().links;
  std::vector<NamedProof> result;
  for (const PairProof& proof : proofs)
    result.push_back({links[proof.first].name, links[proof.second].name, proof});
  return result;
}

std::vector<Segment> checkPath(const SharedRobot& shared, const PathRequest& request) {
  checkLength("clearance", request.clearance);
  checkPositive("budget", request.budget, "seconds");
  checkJobs(request.jobs);
  const std::vector<JointMotion> motions = motionsOf(shared, request);
  warnOfLimits(shared, motions);
  std::vector<DisabledPair> disabled;
  if (!request.srdf.is_none()) {
    const std::string file = pathOf(request.srdf);
    const std::string text = textOfFile(file, "a SRDF");
    disabled = parseSrdf(text, shared.robot(), file);
    const std::string warning = otherRobotWarning(text, shared.robot(), file);
    if (!warning.empty()) warnInPython(warning);
  }
  const BoundedRobot objects = objectsOf(shared, request.objects);
  const PathBodies bodies =
      pathBodies(shared.described(), shared.bounded(), objects, Exemptions(disabled));
  shared.warnOfLeftOut();
  if (bodies.pairs.empty()) warnInPython(kNothingCompared);
  const auto proofs = interruptible([&](const StopFlag& stop) {
    PathControl control{overAfter(request.budget, [&stop] { return stop.load(); }),
                        request.jobs == 0 ? coreCount() : request.jobs};
    return provePath(shared.robot(), bodies, motions, {request.clearance}, control);
  });
  std::vector<Segment> result;
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    Segment segment{i, proofs[i], "", "", {}};
    if (std::isfinite(proofs[i].nearest)) {
      segment.first = bodies.names[proofs[i].first];
      segment.second = bodies.names[proofs[i].second];
      segment.pose = poseOf(shared, motions[i].at(proofs[i].share));
    }
    result.push_back(std::move(segment));
  }
  return result;
}

}  // namespace link_bounds
