// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes the tables from the link back to the root.
#include "robot/reach/reach_bound.h"

#include <cmath>

#include "link_bounds/geometry/box/rounding.h"
#include "robot/reach/arc.h"
#include "robot/urdf/rounding.h"

namespace link_bounds {
namespace {

/// Number of directions between two calls of stop().
constexpr std::size_t kDirectionsPerGlance = 64;

bool usesLater(const JointPath& chain, std::size_t joint, std::size_t variable) {
  for (std::size_t i = joint; i < chain.joints.size(); ++i) {
    if (chain.joints[i].variable == variable) return true;
  }
  return false;
}

/// Max piece of an arc [rad]: about the distance between points of the grid.
double pieceFor(int cells) {
  return 2.0 / cells;
}

/// The error of a slice shrinks with its width, that of the grid with the square of its cells.
int slicesFor(int cells) {
  return cells * cells / 4;
}

/// The angle plus full turns, clamped to the range [rad].
double turnedValue(const Limits& range, double angle) {
  const double turns = std::ceil((range.lower - angle) / (2 * M_PI));
  return std::min(std::max(angle + 2 * M_PI * std::max(turns, 0.0), range.lower), range.upper);
}

}  // namespace

ReachBound::ReachBound(const JointPath& chain, const BoundedLink& link, double radius, int cells,
                       Stop stop)
    : chain_(chain),
      link_(link),
      radius_(radius),
      cells_(cells),
      stop_(std::move(stop)),
      grid_(SupportTable::directions(cells)),
      tables_(chain.joints.size() + 1) {}

std::optional<Aabb> ReachBound::box() {
  const Directions axes{Eigen::Vector3d::UnitX(),  Eigen::Vector3d::UnitY(),
                        Eigen::Vector3d::UnitZ(),  -Eigen::Vector3d::UnitX(),
                        -Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ()};
  const Supports found = supports(0, axes, Slices(chain_.variables.size()));
  if (!found) return std::nullopt;
  const double rounding =
      kRoundoffsPerJoint * kUnitRoundoff * radius_ * static_cast<double>(chain_.count + 1);
  Aabb result;
  for (int axis = 0; axis < 3; ++axis) {
    result.max()[axis] = nextUp((*found)[static_cast<std::size_t>(axis)] + rounding);
    result.min()[axis] = nextDown(-(*found)[static_cast<std::size_t>(axis + 3)] - rounding);
  }
  return result;
}

ReachBound::Supports ReachBound::supports(std::size_t joint, const Directions& directions,
                                          const Slices& slices) {
  if (joint == chain_.joints.size()) return supportsOfLink(directions);
  const PathJoint& moving = chain_.joints[joint];
  if (isShared(moving.variable) && !slices[moving.variable])
    return unionOfSlices(joint, directions, slices);
  const Table child = table(joint + 1, slices);
  if (!child) return std::nullopt;
  return moved(moving, rangeOf(moving, slices), *child, directions);
}

ReachBound::Supports ReachBound::unionOfSlices(std::size_t joint, const Directions& directions,
                                               Slices slices) {
  const std::size_t variable = chain_.joints[joint].variable;
  const auto [lower, upper] = chain_.ranges[variable];
  Supports result;
  const int count = slicesFor(cells_);
  for (int i = 0; i < count; ++i) {
    const auto cut = [=, lower = lower, upper = upper](int end) {
      return end < count ? lower + (upper - lower) * end / count : upper;
    };
    slices[variable] = Limits{cut(i), cut(i + 1)};
    Supports of_slice = supports(joint, directions, slices);
    if (!of_slice) return std::nullopt;
    for (std::size_t k = 0; result && k < directions.size(); ++k)
      (*of_slice)[k] = std::max((*of_slice)[k], (*result)[k]);
    result = std::move(of_slice);
  }
  return result;
}

/// Three directions become the rows of a pose: along its axes, the box has the supports in them.
ReachBound::Supports ReachBound::supportsOfLink(const Directions& directions) const {
  std::vector<double> result;
  result.reserve(directions.size());
  for (std::size_t i = 0; i < directions.size(); i += 3) {
    Eigen::Affine3d directions_from_end = Eigen::Affine3d::Identity();
    for (std::size_t row = 0; row < 3; ++row) {
      directions_from_end.linear().row(static_cast<Eigen::Index>(row)) =
          directions[std::min(i + row, directions.size() - 1)];
    }
    const std::optional<Aabb> box = linkBox(link_, directions_from_end * chain_.after);
    if (!box || (i % kDirectionsPerGlance == 0 && stop_())) return std::nullopt;
    for (Eigen::Index row = 0; row < 3 && result.size() < directions.size(); ++row)
      result.push_back(box->max()[row]);
  }
  return result;
}

ReachBound::Supports ReachBound::moved(const PathJoint& joint, const Limits& range,
                                       const SupportTable& child,
                                       const Directions& directions) const {
  const Arc arc(joint.motion == Motion::kRotation ? range : Limits{0, 0}, pieceFor(cells_));
  const Eigen::Matrix3d to_joint = joint.before.linear().transpose();
  std::vector<double> result;
  result.reserve(directions.size());
  for (const Eigen::Vector3d& direction : directions) {
    if (result.size() % kDirectionsPerGlance == 0 && stop_()) return std::nullopt;
    const Eigen::Vector3d in_joint = to_joint * direction;
    const double along = joint.axis.dot(in_joint);
    const double best =
        joint.motion == Motion::kRotation
            ? arc.support(child, joint.axis, in_joint)
            : child.at(in_joint) + std::max(range.lower * along, range.upper * along);
    result.push_back(joint.before.translation().dot(direction) + best);
    if (!std::isfinite(result.back())) return std::nullopt;  // no bound
  }
  return result;
}

ReachBound::Table ReachBound::table(std::size_t joint, Slices slices) {
  bool has_slices = false;
  for (std::size_t variable = 0; variable < slices.size(); ++variable) {
    if (!slices[variable]) continue;
    if (usesLater(chain_, joint, variable)) {
      has_slices = true;
    } else {
      slices[variable].reset();
    }
  }
  if (!has_slices && tables_[joint]) return tables_[joint];
  Supports found = supports(joint, grid_, slices);
  if (!found) return nullptr;
  for (double& support : *found) {
    if (step_ > 0) support = step_ * (std::ceil(support / step_) + 1);
  }
  auto result = std::make_shared<const SupportTable>(cells_, std::move(*found));
  if (!has_slices) tables_[joint] = result;
  return result;
}

Limits ReachBound::rangeOf(const PathJoint& joint, const Slices& slices) const {
  const auto [lower, upper] = slices[joint.variable].value_or(chain_.ranges[joint.variable]);
  const auto [from, to] =
      std::minmax({joint.factor * lower + joint.offset, joint.factor * upper + joint.offset});
  return {from, to};
}

std::vector<double> ReachBound::guess(const Eigen::Vector3d& direction) const {
  std::vector<double> values;
  for (const Limits& range : chain_.ranges)
    values.push_back(range.lower + (range.upper - range.lower) / 2);
  Eigen::Vector3d remaining = direction;
  for (std::size_t i = 0; i < chain_.joints.size(); ++i) {
    const PathJoint& joint = chain_.joints[i];
    const Limits range = chain_.ranges[joint.variable];
    double& value = values[joint.variable];
    remaining = joint.before.linear().transpose() * remaining;
    const bool is_chosen = !isShared(joint.variable) && tables_[i + 1];
    if (is_chosen && joint.motion == Motion::kTranslation) {
      value = joint.factor * joint.axis.dot(remaining) > 0 ? range.upper : range.lower;
    } else if (is_chosen) {
      const Arc arc(rangeOf(joint, Slices(chain_.variables.size())), pieceFor(cells_));
      const double angle = arc.bestAngle(*tables_[i + 1], joint.axis, remaining);
      const Limits angles = rangeOf(joint, Slices(chain_.variables.size()));
      value = (turnedValue(angles, angle) - joint.offset) / joint.factor;
      value = std::min(std::max(value, range.lower), range.upper);
    }
    if (joint.motion == Motion::kRotation) {
      const double angle = joint.factor * value + joint.offset;
      remaining = Eigen::AngleAxisd(-angle, joint.axis) * remaining;
    }
  }
  return values;
}

}  // namespace link_bounds
