// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/swept_search.h"

#include <algorithm>
#include <vector>

#include "geometry/distance/triangle_tree.h"
#include "robot/pairs/body_cloud.h"
#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

/// Slabs per shape: more fit better, and take longer to compare. Adjacent slabs become one cylinder
/// if that adds no more than the share kAdded to a radius.
constexpr std::size_t kSlabs = 64;
constexpr double kAdded = 0.03;

/// Between `low` and `high` along the axis, no point is farther from the axis than `radius` [m].
struct Slab {
  double low;
  double high;
  double radius = -1;  ///< negative: there is no point
};

/// Merges adjacent slabs whose radii hardly differ.
std::vector<Slab> merged(const std::vector<Slab>& slabs) {
  std::vector<Slab> result;
  double smallest = 0;
  for (const Slab& slab : slabs) {
    if (!result.empty()) {
      Slab& last = result.back();
      const double low = std::min(smallest, slab.radius);
      const double high = std::max(last.radius, slab.radius);
      if ((low >= 0 && high - low <= kAdded * high) || high < 0) {
        last = {last.low, slab.high, high};
        smallest = low;
        continue;
      }
    }
    result.push_back(slab);
    smallest = slab.radius;
  }
  return result;
}

/// A body that turns about an axis. Triangles are cut into slabs across the axis. In a slab the
/// farthest point from the axis is an end of a part of an edge, because the distance from a line is
/// convex.
class Sweep {
 public:
  Sweep(const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis) : pose_(pose), axis_(axis) {
    // Not Quaterniond::FromTwoVectors, which gives no rotation if the axis is nearly -z.
    const Eigen::Vector3d x = axis.unitOrthogonal();
    turned_.linear() << x, axis.cross(x), axis;
  }

  void add(const BodyShape& shape) {
    const Axis axis{pose_.inverse() * Eigen::Vector3d::Zero(), pose_.linear().transpose() * axis_};
    const BodyCloud cloud({{shape}});
    const double at = axis.direction.dot(axis.origin);
    rounding_ = kPoseRounding * (cloud.magnitude() + axis.origin.norm());
    Slab all{-cloud.support(-axis.direction) - at, cloud.support(axis.direction) - at,
             cloud.farthestFrom(axis)};
    if (!shape.triangles || shape.triangles->solid != Solid::kNone || !(all.low < all.high))
      return addCylinder(all);
    for (const Slab& slab : merged(slabsOf(shape, all)))
      if (slab.radius >= 0) addCylinder(slab);
  }

  Body result() const { return body_; }

 private:
  std::vector<Slab> slabsOf(const BodyShape& shape, const Slab& all) const {
    std::vector<Slab> slabs;
    const double height = (all.high - all.low) / kSlabs;
    for (std::size_t i = 0; i < kSlabs; ++i)
      slabs.push_back({all.low + height * static_cast<double>(i),
                       all.low + height * static_cast<double>(i + 1)});
    const TriangleTree& tree = *shape.triangles;
    std::vector<Eigen::Vector3d> vertices;
    for (const Eigen::Vector3d& vertex : tree.vertices)
      vertices.push_back(turned_.inverse() * (pose_ * (shape.shape.link_from_shape * vertex)));
    for (const auto& [a, b, c] : tree.triangles) {
      addEdge(vertices[a], vertices[b], slabs);
      addEdge(vertices[b], vertices[c], slabs);
      addEdge(vertices[c], vertices[a], slabs);
    }
    return slabs;
  }

  /// Adds an edge to all slabs that it meets or misses only by rounding.
  void addEdge(Eigen::Vector3d a, Eigen::Vector3d b, std::vector<Slab>& slabs) const {
    if (a.z() > b.z()) std::swap(a, b);
    for (Slab& slab : slabs) {
      if (slab.high < a.z() - rounding_ || slab.low > b.z() + rounding_) continue;
      for (const double end : {slab.low, slab.high}) {
        const double share = b.z() > a.z() ? (end - a.z()) / (b.z() - a.z()) : 0;
        const Eigen::Vector3d at = a + std::min(std::max(share, 0.0), 1.0) * (b - a);
        slab.radius = std::max(slab.radius, at.head<2>().norm());
      }
      if (b.z() == a.z()) slab.radius = std::max(slab.radius, b.head<2>().norm());
    }
  }

  void addCylinder(const Slab& slab) {
    const double diameter = 2 * (slab.radius + 2 * rounding_);
    Shape& cylinder = body_.shapes.emplace_back().shape;
    cylinder.solid = Solid::kCylinder;
    cylinder.size = {diameter, diameter, slab.high - slab.low + 4 * rounding_};
    cylinder.link_from_shape = turned_ * Eigen::Translation3d(0, 0, (slab.low + slab.high) / 2);
  }

  Eigen::Isometry3d pose_;
  Eigen::Vector3d axis_;
  Eigen::Isometry3d turned_ = Eigen::Isometry3d::Identity();  ///< z along the axis
  double rounding_ = 0;
  Body body_;
};

/// A sweep is kept only if it leaves this share of what the nearest distance exceeds the wanted
/// clearance by.
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

/// A pointer without ownership: the caller keeps the body alive.
std::shared_ptr<const PairBody> borrowed(const PairBody& body) {
  return {std::shared_ptr<const PairBody>(), &body};
}

}  // namespace

Body sweptBody(const Body& body, const Eigen::Isometry3d& pose, const Eigen::Vector3d& axis) {
  Sweep sweep(pose, axis);
  for (const BodyShape& shape : body.shapes)
    sweep.add(shape);
  return sweep.result();
}

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

/// Chooses the sweep that enlarges a body least.
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
