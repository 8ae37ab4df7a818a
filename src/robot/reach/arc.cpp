// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// reach_bound.h has the proof.
#include "robot/reach/arc.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace link_bounds {
namespace {

/// At larger angles, doubles are too far apart to cut a turn into pieces [rad].
constexpr double kMaxAngle = 1e9;

/// Rounding of 2 pi.
constexpr double kAngleRounding = 1e-12;

/// A test compiles this with a smaller share, so that joints turn too little. Its check of the
/// proofs has to find that.
#ifndef LINK_BOUNDS_SHARE_OF_MOTION
#define LINK_BOUNDS_SHARE_OF_MOTION 1
#endif
constexpr double kArcShare = LINK_BOUNDS_SHARE_OF_MOTION;

Limits anglesOf(const Limits& range) {
  const bool is_turn = range.upper - range.lower >= 2 * M_PI - kAngleRounding ||
                       std::max(std::abs(range.lower), std::abs(range.upper)) > kMaxAngle;
  return is_turn ? Limits{-kArcShare * M_PI, kArcShare * M_PI}
                 : Limits{kArcShare * range.lower, kArcShare * range.upper};
}

/// A direction that turns about an axis.
struct TurningDirection {
  Eigen::Vector3d constant;
  Eigen::Vector3d at_0;   ///< the part that turns, at the angle 0
  Eigen::Vector3d at_90;  ///< the part that turns, after a quarter turn of the joint

  TurningDirection(const Eigen::Vector3d& axis, const Eigen::Vector3d& direction)
      : constant(axis * axis.dot(direction)),
        at_0(direction - constant),
        at_90(direction.cross(axis)) {}

  Eigen::Vector3d at(double cosine, double sine) const {
    return constant + cosine * at_0 + sine * at_90;
  }
};

}  // namespace

Arc::Arc(const Limits& range, double max_piece) {
  const auto [lower, upper] = anglesOf(range);
  const double count = std::max(1.0, std::ceil((upper - lower) / max_piece));
  const auto angle = [&, lower = lower, upper = upper](double i) {
    return i < count ? lower + (upper - lower) * (i / count) : upper;
  };
  for (double i = 0; i <= count; ++i) {
    const double half = (angle(i + 1) - angle(i)) / 2;
    const double sine = std::sin(half);
    const double cosine = std::cos(half);
    pieces_.push_back(
        {angle(i), std::cos(angle(i)), std::sin(angle(i)), cosine * cosine, sine * sine});
  }
}

double Arc::support(const SupportTable& support, const Eigen::Vector3d& axis,
                    const Eigen::Vector3d& direction) const {
  const TurningDirection turning(axis, direction);
  const double against = support.at(-turning.constant);
  double best = -std::numeric_limits<double>::infinity();
  double before = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double bracket = against + support.at(turning.at(pieces_[i].cosine, pieces_[i].sine));
    if (std::isnan(bracket)) return bracket;  // no bound
    best = std::max(best, bracket);
    if (i > 0) {
      // The max of the sinusoid inside the piece: the mean and the half difference of both ends
      // determine it.
      const Piece& piece = pieces_[i - 1];
      const double mean = (before + bracket) / 2;
      const double half = (bracket - before) / 2;
      if (std::abs(half) * piece.cosine2 < mean * piece.sine2)
        best = std::max(best, std::sqrt(mean * mean / piece.cosine2 + half * half / piece.sine2));
    }
    before = bracket;
  }
  return best - against;
}

double Arc::bestAngle(const SupportTable& support, const Eigen::Vector3d& axis,
                      const Eigen::Vector3d& direction) const {
  const TurningDirection turning(axis, direction);
  double best = -std::numeric_limits<double>::infinity();
  double angle = 0;
  for (const Piece& piece : pieces_) {
    const double value = support.at(turning.at(piece.cosine, piece.sine));
    if (value > best) angle = piece.angle;
    best = std::max(best, value);
  }
  return angle;
}

}  // namespace link_bounds
