// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A rough bound of every link at once, then better ones, round by round.
#include "robot/reach/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "link_bounds/robot/urdf/kinematics.h"
#include "robot/threads/row_threads.h"
#include "robot/urdf/joints_above.h"
#include "robot/urdf/simple_joints.h"

namespace link_bounds {
namespace {

/// Cells of the tables (support_table.h) in the first and in the last round. The error of a bound
/// shrinks with their square; time and memory grow with the third and second power. Beyond the last
/// round, a thread would need hundreds of megabytes.
constexpr int kFirstCells = 8;
constexpr int kLastCells = 256;

/// A link behind more moving joints keeps its rough bound: the recursion must fit on the stack.
constexpr std::size_t kMaxJoints = 500;

/// Covers the rounding of a sum of as many terms as a robot has joints.
constexpr double kRadiusRounding = 1 + 1e-9;

/// How many values of a variable that several joints share are tried as starts of a search.
constexpr int kSharedStarts = 9;

/// By link: upper bound of the distance of its frame from the root's origin [m]; infinite if the
/// range of a joint above it is not known. One pass, because robots may have thousands of joints.
std::vector<double> frameDistances(const Robot& robot, const std::vector<JointRange>& ranges) {
  std::vector<double> distances(robot.links.size(), 0.0);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    const JointRange& range = ranges[i];
    double& distance = distances[joint.child];
    distance = distances[joint.parent] + joint.parent_from_joint.translation().norm();
    if (joint.motion == Motion::kTranslation)
      distance += std::max(std::abs(range.lower), std::abs(range.upper));
    if (!range.is_known) distance = std::numeric_limits<double>::infinity();
  }
  return distances;
}

/// The values nearest to 0 of the joints that follow no other one; those that are 0 are left out.
std::map<std::string, double> nearestToZero(const Robot& robot,
                                            const std::vector<JointRange>& ranges) {
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double value = std::min(std::max(ranges[i].lower, 0.0), ranges[i].upper);
    if (ranges[i].lead.leader == i && value != 0) values[robot.joints[i].name] = value;
  }
  return values;
}

class ReachSearch {
 public:
  ReachSearch(const Robot& robot, const BoundedRobot& bounded,
              const std::vector<JointRange>& ranges, const ReachGoal& goal);

  std::vector<std::optional<Reach>> run();

 private:
  void boundRoughly();
  void refineAll(int cells);
  void refine(std::size_t link, int cells);
  std::vector<double> startFor(std::size_t link, const JointPath& chain, const ReachBound& bound,
                               std::size_t face) const;
  void findPose(std::size_t link, const JointPath& chain, const ReachBound& bound,
                std::size_t face);
  void showProgress();

  const Robot& robot_;
  const std::vector<std::size_t>& indices_;
  const std::vector<JointRange>& ranges_;
  const ReachGoal& goal_;
  std::vector<BoundedLink> links_;      ///< without padding
  std::map<std::string, double> rest_;  ///< a pose within all limits, without joints at 0
  std::vector<double> radii_;           ///< by link: see linkRadii() [m]
  std::vector<std::optional<Reach>> reaches_;
  std::mutex mutex_;  ///< guards reaches_ while several threads refine
};

ReachSearch::ReachSearch(const Robot& robot, const BoundedRobot& bounded,
                         const std::vector<JointRange>& ranges, const ReachGoal& goal)
    : robot_(robot),
      indices_(bounded.indices),
      ranges_(ranges),
      goal_(goal),
      links_(bounded.links),
      rest_(nearestToZero(robot, ranges)),
      radii_(linkRadii(robot, bounded, ranges)),
      reaches_(bounded.links.size()) {
  for (BoundedLink& link : links_)
    link.padding = 0;
}

void ReachSearch::boundRoughly() {
  const std::vector<Eigen::Isometry3d> poses = linkPoses(robot_, jointValues(robot_, rest_));
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const std::optional<Aabb> box = linkBox(links_[i], Eigen::Affine3d(poses[indices_[i]]));
    if (!box || !std::isfinite(radii_[i])) continue;
    Reach& reach = reaches_[i].emplace();
    for (std::size_t face = 0; face < kFaces; ++face)
      reach.faces[face] = {face < 3 ? -radii_[i] : radii_[i], faceOf(*box, face), rest_};
  }
}

/// The values from which a search starts. For a variable that several joints share, several values
/// are tried.
std::vector<double> ReachSearch::startFor(std::size_t link, const JointPath& chain,
                                          const ReachBound& bound, std::size_t face) const {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  direction[static_cast<Eigen::Index>(face % 3)] = face < 3 ? -1 : 1;
  std::vector<double> values = bound.guess(direction);
  double best = faceAt(chain, links_[link], face, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!chain.isShared(k)) continue;
    const auto [lower, upper] = chain.ranges[k];
    for (int i = 0; i < kSharedStarts; ++i) {
      std::vector<double> other = values;
      other[k] = std::min(lower + (upper - lower) * i / (kSharedStarts - 1), upper);
      const double at = faceAt(chain, links_[link], face, other);
      if (beyond(face, at, best) <= 0) continue;
      best = at;
      values = other;
    }
  }
  return values;
}

void ReachSearch::findPose(std::size_t link, const JointPath& chain, const ReachBound& bound,
                           std::size_t face) {
  const AttainedFace found =
      attainedFrom(chain, links_[link], face, startFor(link, chain, bound, face), goal_.stop);
  const std::lock_guard<std::mutex> lock(mutex_);
  ReachFace& best = reaches_[link]->faces[face];
  if (beyond(face, found.at, best.attained) <= 0) return;
  best.attained = found.at;
  for (std::size_t k = 0; k < found.values.size(); ++k)
    best.pose[robot_.joints[chain.variables[k]].name] = found.values[k];
}

void ReachSearch::refine(std::size_t link, int cells) {
  const JointPath chain = jointPath(robot_, ranges_, robot_.root, indices_[link]);
  if (chain.joints.size() > kMaxJoints) return;
  ReachBound bound(chain, links_[link], radii_[link], cells, goal_.stop);
  const std::optional<Aabb> box = bound.box();
  if (!box) return;
  for (std::size_t face = 0; face < kFaces; ++face) {
    findPose(link, chain, bound, face);
    const std::lock_guard<std::mutex> lock(mutex_);
    double& at = reaches_[link]->faces[face].at;
    if (beyond(face, at, faceOf(*box, face)) > 0) at = faceOf(*box, face);
  }
  showProgress();
}

void ReachSearch::showProgress() {
  if (!goal_.progress) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t done = 0;
  std::size_t total = 0;
  double max_gap = 0;
  for (const auto& reach : reaches_) {
    if (!reach) continue;
    ++total;
    if (reach->maxGap() <= goal_.accuracy) ++done;
    max_gap = std::max(max_gap, reach->maxGap());
  }
  goal_.progress(done, total, max_gap);
}

void ReachSearch::refineAll(int cells) {
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const bool is_first = cells == kFirstCells;
    if (reaches_[i] && (is_first || reaches_[i]->maxGap() > goal_.accuracy)) waiting.push_back(i);
  }
  forRows(0, waiting.size(), coreCount(), 1, [&](unsigned, std::size_t i, std::size_t) {
    if (!goal_.stop()) refine(waiting[i], cells);
  });
}

std::vector<std::optional<Reach>> ReachSearch::run() {
  boundRoughly();
  for (int cells = kFirstCells; cells <= kLastCells && !goal_.stop(); cells *= 2)
    refineAll(cells);
  return std::move(reaches_);
}

}  // namespace

Aabb Reach::box() const {
  return Aabb(Eigen::Vector3d(faces[0].at, faces[1].at, faces[2].at),
              Eigen::Vector3d(faces[3].at, faces[4].at, faces[5].at));
}

double Reach::maxGap() const {
  double result = 0;
  for (const ReachFace& face : faces)
    result = std::max(result, face.gap());
  return result;
}

std::vector<double> linkRadii(const Robot& robot, const BoundedRobot& bounded,
                              const std::vector<JointRange>& ranges) {
  const std::vector<double> distances = frameDistances(robot, ranges);
  std::vector<double> radii;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const double size = std::sqrt(3) * magnitude(bounded.links[i]);
    radii.push_back(kRadiusRounding * (distances[bounded.indices[i]] + size));
  }
  return radii;
}

std::vector<std::optional<Reach>> reachOf(const Robot& robot, const BoundedRobot& bounded,
                                          const std::vector<JointRange>& ranges,
                                          const ReachGoal& goal) {
  return ReachSearch(robot, bounded, ranges, goal).run();
}

std::string whyNoReach(const Robot& robot, const BoundedRobot& bounded,
                       const std::vector<JointRange>& ranges, std::size_t link) {
  if (!bounded.links[link].isWhole()) return bounded.links[link].missing;
  std::vector<std::size_t> unknown;
  for (const std::size_t joint : jointsAbove(robot, bounded.indices[link]))
    if (!ranges[joint].is_known) unknown.push_back(joint);
  return unknown.empty() ? "its size and pose give no finite box" : missingRanges(robot, unknown);
}

std::optional<Reach> unionOf(const std::vector<std::optional<Reach>>& reaches) {
  std::optional<Reach> result;
  for (const std::optional<Reach>& reach : reaches) {
    if (!reach) continue;
    if (!result) {
      result = reach;
      continue;
    }
    for (std::size_t i = 0; i < kFaces; ++i) {
      ReachFace& face = result->faces[i];
      const ReachFace& other = reach->faces[i];
      if (beyond(i, other.at, face.at) > 0) face.at = other.at;
      if (beyond(i, other.attained, face.attained) <= 0) continue;
      face.attained = other.attained;
      face.pose = other.pose;
    }
  }
  return result;
}

}  // namespace link_bounds
