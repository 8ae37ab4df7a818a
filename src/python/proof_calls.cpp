// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/proof_calls.h"

#include <sstream>

#include "link_bounds/robot/urdf/kinematics.h"
#include "python/joint_input.h"
#include "python/text.h"
#include "robot/urdf/joints_above.h"
#include "robot/urdf/simple_joints.h"
#include "tools/command_line/interrupt.h"

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
  return jointRanges(shared.robot(), given);
}

/// Why nothing is proven of a link.
std::string whyNone(const SharedRobot& shared, const std::vector<JointRange>& ranges,
                    std::size_t link) {
  const BoundedLink& bounded = shared.bounded().links[link];
  if (!bounded.isWhole()) return bounded.missing;
  const std::vector<std::size_t> unknown =
      unknownOf(ranges, jointsAbove(shared.robot(), shared.bounded().indices[link]));
  return unknown.empty() ? "its size and pose give no finite box"
                         : missingRanges(shared.robot(), unknown);
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

}  // namespace

py::array boxOf(const Reach& reach) {
  return facesOf(reach, [](const ReachFace& face) { return face.at; });
}

py::array gapOf(const Reach& reach) {
  return facesOf(reach, [](const ReachFace& face) { return face.gap(); });
}

py::dict reachOfRobot(const SharedRobot& shared, const ProofRequest& request) {
  const std::vector<JointRange> ranges = rangesOf(shared, request);
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
      warnInPython("link \"" + name + "\": " + whyNone(shared, ranges, i));
    }
  }
  warnOfGap(max_gap, request.accuracy);
  return result;
}

std::vector<NamedProof> pairsOfRobot(const SharedRobot& shared, const ProofRequest& request,
                                     double clearance, double touching, bool adjacent,
                                     unsigned jobs) {
  checkLength("clearance", clearance);
  checkLength("touching", touching);
  const std::vector<JointRange> ranges = rangesOf(shared, request);
  const std::vector<PairProof> proofs = interruptible([&](const StopFlag& stop) {
    ProofControl control;
    control.is_over = overAfter(request.budget, [&stop] { return stop.load(); });
    control.threads = jobs;
    const PairGoal goal{clearance, request.accuracy, touching};
    return provePairs(shared.robot(), shared.bounded(), ranges, goal, control, {adjacent, false});
  });
  const std::vector<BoundedLink>& links = shared.bounded().links;
  std::vector<NamedProof> result;
  for (const PairProof& proof : proofs)
    result.push_back({links[proof.first].name, links[proof.second].name, proof});
  return result;
}

}  // namespace link_bounds
