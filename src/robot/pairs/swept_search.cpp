// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/swept_search.h"

#include <algorithm>

#include "robot/pairs/swept_body.h"

namespace link_bounds {
namespace {

/// Of the distance at which a pose was found: a sweep that leaves less is not worth it.
constexpr double kLeft = 0.5;

/// Drops variables that no joint has.
void dropUnused(JointPath& path) {
  for (std::size_t v = path.variables.size(); v-- > 0;) {
    const auto has_it = [v](const PathJoint& joint) { return joint.variable == v; };
    if (std::any_of(path.joints.begin(), path.joints.end(), has_it)) continue;
    path.variables.erase(path.variables.begin() + static_cast<std::ptrdiff_t>(v));
    path.ranges.erase(path.ranges.begin() + static_cast<std::ptrdiff_t>(v));
    for (PathJoint& joint : path.joints) {
      if (joint.variable > v) --joint.variable;
    }
  }
}

/// How far the body extends from the axis of the joint [m].
double leverOf(const PairBody& body, const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis) {
  const Eigen::Isometry3d back = pose.inverse();
  return body.hull.cloud.farthestFrom({back.translation(), back.linear() * axis});
}

/// The caller keeps it alive.
std::shared_ptr<const PairBody> borrowed(const PairBody& body) {
  return {std::shared_ptr<const PairBody>(), &body};
}

}  // namespace

SweptSearch::SweptSearch(const JointPath& path, const PairBody& first, const PairBody& second,
                         const PairGoal& goal, double nearest)
    : goal_(goal), nearest_(nearest), given_{path, borrowed(first), borrowed(second), nullptr} {
  nextCandidate();
}

std::size_t SweptSearch::bytes() const {
  std::size_t sum = 0;
  for (const Stage* stage : {chosen_.get(), candidate_.get()})
    sum += stage ? stage->search->bytes() : 0;
  return sum;
}

void SweptSearch::advance() {
  if (!candidate_) return chosen_->search->advance();
  PairSearch& search = *candidate_->search;
  if (!search.isExplored() && !search.collides()) return search.advance();
  if (search.nearest().values.size() < search.path().variables.size()) {
    // The swept body is so large that no pose of it has a finite distance.
    is_settled_[is_at_second_ ? 1 : 0] = true;
    return nextCandidate();
  }
  for (std::size_t v = 0; v < search.path().variables.size(); ++v)
    hint_[search.path().variables[v]] = search.nearest().values[v];
  if (search.nearest().upper - goal_.clearance >= kLeft * (nearest_ - goal_.clearance)) {
    nearest_ = search.nearest().upper;
    chosen_ = std::move(candidate_);
  } else {
    is_settled_[is_at_second_ ? 1 : 0] = true;
  }
  nextCandidate();
}

/// That which makes a body the least larger.
void SweptSearch::nextCandidate() {
  candidate_ = nullptr;
  const Stage& stage = chosen_ ? *chosen_ : given_;
  const std::vector<PathJoint>& joints = stage.path.joints;
  if (joints.empty()) return;
  if (joints.front().motion != Motion::kRotation) is_settled_[0] = true;
  if (joints.back().motion != Motion::kRotation) is_settled_[1] = true;
  if (is_settled_[0] && is_settled_[1]) return;
  is_at_second_ = is_settled_[0];
  if (!is_settled_[0] && !is_settled_[1]) {
    is_at_second_ = leverOf(*stage.second, stage.path.after, joints.back().axis) <
                    leverOf(*stage.first, joints.front().before.inverse(), joints.front().axis);
  }
  candidate_ = swept(stage, is_at_second_);
}

std::unique_ptr<SweptSearch::Stage> SweptSearch::swept(const Stage& stage, bool at_second) const {
  auto result = std::make_unique<Stage>(Stage{stage.path, stage.first, stage.second, nullptr});
  JointPath& path = result->path;
  if (at_second) {
    const PathJoint joint = path.joints.back();
    result->second = std::make_shared<const PairBody>(
        pairBody(sweptBody(*stage.second->body, path.after, joint.axis)));
    path.joints.pop_back();
    path.after = joint.before;
  } else {
    const PathJoint joint = path.joints.front();
    result->first = std::make_shared<const PairBody>(
        pairBody(sweptBody(*stage.first->body, joint.before.inverse(), joint.axis)));
    path.joints.erase(path.joints.begin());
  }
  dropUnused(path);
  result->search =
      std::make_unique<PairSearch>(path, *result->first, *result->second, goal_, false);
  return result;
}

}  // namespace link_bounds
