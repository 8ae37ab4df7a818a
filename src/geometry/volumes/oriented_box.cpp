// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches over orientations: the size of a box is that of the axis-aligned box of the turned link.
#include "link_bounds/geometry/volumes/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/shape/shape_extents.h"
#include "geometry/support/table/direction_fold.h"
#include "link_bounds/geometry/box/length.h"
#include "link_bounds/geometry/box/rounding.h"

namespace link_bounds {
namespace {

constexpr int kDirections = 16;        ///< per side of the square that all directions fold to
constexpr int kSpins = 12;             ///< about each direction, in a quarter turn
constexpr double kFirstStep = 0.08;    ///< about half the angle between two samples [rad]
constexpr double kLastStep = 1e-8;     ///< [rad]
constexpr double kMinGain = 1e-6;      ///< of the volume; the header promises it
constexpr int kMaxRefinements = 1000;  ///< typically some tens

constexpr double kFlatPerDiagonal = 1e-9;    ///< smallest width that counts; see the header
constexpr double kFlatPerMagnitude = 1e-12;  ///< larger than rounding and its pads

constexpr double kTurnPad =
    256 * kUnitRoundoff;  ///< of the magnitude; turning there and back rounds
/// Relative pad of size and magnitude; two quaternions and a sum round by half of it.
constexpr double kPlacedPad = 64 * kUnitRoundoff;

struct Candidate {
  Eigen::Quaterniond orientation;
  double volume;  ///< see Search
};

Eigen::Affine3d boxFromLink(const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3d link_from_box = orientation.toRotationMatrix();
  return Eigen::Affine3d(link_from_box.transpose());
}

/// Compares boxes of one link in any orientation. What rounding adds to a face depends on the
/// orientation, so boxes are compared without it; otherwise it would decide which box of a flat
/// link is the smallest.
class Search {
 public:
  Search(const BoundedLink& link, const Aabb& box_at_rest)
      : link_(link),
        extents_(link.shapes.begin(), link.shapes.end()),
        diagonal_(std::max(length(box_at_rest.sizes()), 1e-300)),
        flat_(std::max(kFlatPerDiagonal, kFlatPerMagnitude * (magnitude(link) / diagonal_))) {
    for (ShapeExtents& extents : extents_)
      extents.pad_per_entry = 0;
  }

  /// In units of diagonal_ cubed, which neither overflow nor vanish. A width below flat_ counts as
  /// flat_, so the flat box with the smallest area is the smallest.
  double volume(const Eigen::Array3d& widths) const {
    return (widths / diagonal_).max(flat_).prod();
  }

  Candidate candidate(const Eigen::Quaterniond& orientation) {
    const Eigen::Affine3d box_from_link = boxFromLink(orientation);
    Aabb box;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      Aabb shape;
      if (!placeShape(link_.shapes[i], box_from_link, nullptr, extents_[i], shape)) {
        return {orientation, std::numeric_limits<double>::infinity()};
      }
      box.extend(shape);
    }
    return {orientation, volume(padded(box, link_.padding).sizes().array())};
  }

 private:
  static double length(const Eigen::Vector3d& v) {
    return link_bounds::length(v.x(), v.y(), v.z());
  }

  const BoundedLink& link_;
  std::vector<ShapeExtents> extents_;  ///< by shape, without what is added against rounding
  double diagonal_;                    ///< of the box at rest [m], the unit of length
  double flat_;                        ///< the smallest width that counts, in that unit
};

void keepBetter(const Candidate& candidate, Candidate& best) {
  if (candidate.volume < best.volume) best = candidate;
}

/// Tries the axes of each shape, also where a scale has changed their lengths.
void tryShapes(const BoundedLink& link, Search& search, Candidate& best) {
  for (const Shape& shape : link.shapes) {
    Eigen::Matrix3d axes = shape.link_from_shape.linear().colwise().normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1)).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    const Eigen::Quaterniond orientation(axes);
    if (orientation.coeffs().allFinite())
      keepBetter(search.candidate(orientation.normalized()), best);
  }
}

/// Tries directions all over the half sphere for the third axis of the box, and turns about each.
/// Every orientation has three samples near it, because any axis may be the third one.
void tryGrid(Search& search, Candidate& best) {
  for (int i = 0; i < kDirections * kDirections; ++i) {
    const double s = (2 * (i % kDirections) + 1.0) / kDirections - 1;
    const double t = (2 * (i / kDirections) + 1.0) / kDirections - 1;
    const Eigen::Vector3d d = directionAt(s, t, faceAt(s, t)).normalized();
    const auto third =
        Eigen::Quaterniond(1 + d.z(), -d.y(), d.x(), 0).normalized();  // z to d, d.z() >= 0
    for (int spin = 0; spin < kSpins; ++spin) {
      const Eigen::AngleAxisd turn(M_PI / 2 * spin / kSpins, Eigen::Vector3d::UnitZ());
      keepBetter(search.candidate((third * turn).normalized()), best);
    }
  }
}

/// The axes of the box, its diagonals and those of its faces, each in both directions.
std::vector<Eigen::Vector3d> turnAxes() {
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < 27; ++i) {
    const Eigen::Vector3d axis(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (!axis.isZero(0)) result.push_back(axis.normalized());
  }
  return result;
}

/// Turns the best box in small steps, and halves the step when none improves it. A rod gains a
/// little by each of very many steps.
void refine(Search& search, Candidate& best) {
  const std::vector<Eigen::Vector3d> axes = turnAxes();
  double step = kFirstStep;
  for (int i = 0; i < kMaxRefinements && step > kLastStep; ++i) {
    const Candidate center = best;
    for (const Eigen::Vector3d& axis : axes) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(step, axis));
      keepBetter(search.candidate((center.orientation * turn).normalized()), best);
    }
    if (best.volume == center.volume) step /= 2;
  }
}

OrientedBox toOrientedBox(const Aabb& box, const Eigen::Quaterniond& orientation, double pad) {
  const CenterRadius form = toCenterRadius(padded(box, pad));
  return {orientation * form.center, orientation, 2 * form.radius};
}

std::optional<OrientedBox> ifFinite(const OrientedBox& box) {
  const bool is_finite =
      box.center.allFinite() && box.orientation.coeffs().allFinite() && box.size.allFinite();
  if (!is_finite) return std::nullopt;
  return box;
}

}  // namespace

std::optional<OrientedBox> orientedBox(const BoundedLink& link) {
  const Eigen::Quaterniond unturned = Eigen::Quaterniond::Identity();
  const std::optional<Aabb> box = linkBox(link, boxFromLink(unturned));
  if (!box) return std::nullopt;
  const OrientedBox at_rest = toOrientedBox(*box, unturned, 0);
  Search search(link, *box);
  Candidate best = search.candidate(unturned);
  tryShapes(link, search, best);
  tryGrid(search, best);
  refine(search, best);
  const std::optional<Aabb> turned_box = linkBox(link, boxFromLink(best.orientation));
  if (!turned_box) return ifFinite(at_rest);
  const OrientedBox turned =
      toOrientedBox(*turned_box, best.orientation, kTurnPad * magnitude(link));
  const bool is_better =
      search.volume(turned.size.array()) < (1 - kMinGain) * search.volume(at_rest.size.array());
  return ifFinite(is_better ? turned : at_rest);
}

std::optional<OrientedBox> placed(const OrientedBox& box,
                                  const Eigen::Isometry3d& world_from_link) {
  const Eigen::Matrix3d linear = world_from_link.linear();
  const Eigen::Vector3d translation = world_from_link.translation();
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(linear).normalized();
  // Where the pose is not a rotation, it moves a point of the box by at most this fraction of the
  // point's distance from the centre.
  const double deviation =
      (rotation.toRotationMatrix().transpose() * linear - Eigen::Matrix3d::Identity())
          .cwiseAbs()
          .sum();
  const double magnitude =
      (linear.cwiseAbs() * box.center.cwiseAbs() + translation.cwiseAbs()).sum();
  const double pad = (deviation + kPlacedPad) * box.size.sum() + kPlacedPad * magnitude;
  return ifFinite({linear * box.center + translation, (rotation * box.orientation).normalized(),
                   (box.size.array() + pad + std::numeric_limits<double>::min()).matrix()});
}

}  // namespace link_bounds
