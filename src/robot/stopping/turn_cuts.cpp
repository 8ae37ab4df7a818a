// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds cuts to the joint that gains most for the growth of the number of boxes, again and again.
#include "robot/stopping/turn_cuts.h"

namespace link_bounds {
namespace {

/// A turn is cut into pieces. For a set of radius r a piece of 2 p costs up to r (1 / cos(p) - 1);
/// beyond this p it is worse than the middle alone [rad].
constexpr double kMaxHalfPiece = 1.2;

/// Cuts that gain less are not worth their time [m].
constexpr double kMinCutGain = 5e-4;

/// Max number of boxes of the link. With 16, half of the faces of a Gen3 are too far out by at most
/// 0.6 mm + 10 % of their motion; with 40, and mere padding for turns, it was 6 mm.
constexpr std::size_t kMaxLeaves = 16;

double widthOf(const MovingStep& step) {
  return step.offsets.upper - step.offsets.lower;
}

/// The next number of cuts that helps: a piece must be less than half a turn.
std::size_t nextCuts(const MovingStep& step, std::size_t cuts) {
  const auto fewest = static_cast<std::size_t>(std::floor(widthOf(step) / (2 * kMaxHalfPiece))) + 2;
  return cuts == 1 ? fewest : cuts + 1;
}

/// About the max error that a turn adds to a face [m].
double lossOf(const MovingStep& step, const SweptBall& ball, std::size_t cuts) {
  const double half = widthOf(step) / 2;
  if (cuts == 1) return ball.radius * chordOf(half);
  return ball.radius * (1 / std::cos(half / static_cast<double>(cuts - 1)) - 1);
}

/// One cut is in the middle; else the first and the last are at the ends.
void cut(MovingStep& step, std::size_t cuts) {
  const double piece = widthOf(step) / static_cast<double>(std::max<std::size_t>(cuts - 1, 1));
  step.half_piece = piece / 2;
  for (std::size_t k = 0; k < cuts; ++k) {
    double angle = step.offsets.lower + piece * static_cast<double>(k);
    if (cuts == 1) angle += step.half_piece;
    if (k > 0 && k + 1 == cuts) angle = step.offsets.upper;
    step.turns.push_back(Eigen::AngleAxisd(angle, step.joint->axis).toRotationMatrix());
  }
}

}  // namespace

void chooseCuts(std::vector<MovingStep>& steps, const std::vector<SweptBall>& balls) {
  std::vector<std::size_t> cuts(steps.size(), 1);
  std::size_t leaves = 1;
  for (;;) {
    std::size_t best = steps.size();
    double best_rate = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].joint->kind != MovingJoint::Kind::kTurn) continue;
      const std::size_t next = nextCuts(steps[i], cuts[i]);
      if (leaves / cuts[i] * next > kMaxLeaves) continue;
      const double gain =
          lossOf(steps[i], balls[i + 1], cuts[i]) - lossOf(steps[i], balls[i + 1], next);
      const double rate = gain / std::log(static_cast<double>(next) / static_cast<double>(cuts[i]));
      if (gain < kMinCutGain || rate <= best_rate) continue;
      best = i;
      best_rate = rate;
    }
    if (best == steps.size()) break;
    const std::size_t next = nextCuts(steps[best], cuts[best]);
    leaves = leaves / cuts[best] * next;
    cuts[best] = next;
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].joint->kind == MovingJoint::Kind::kTurn) cut(steps[i], cuts[i]);
  }
}

}  // namespace link_bounds
