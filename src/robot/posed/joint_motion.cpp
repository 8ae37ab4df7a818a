// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The coefficients are those of ros_controllers' QuinticSplineSegment, times powers of the
// duration.
#include "robot/posed/joint_motion.h"

#include <algorithm>
#include <cmath>

#include "robot/urdf/rounding.h"

namespace link_bounds {

JointMotion::JointMotion(const WayPoint& from, const WayPoint& to)
    : joints_(from.positions.size(), Polynomial{}) {
  const bool is_cubic = !from.velocities.empty() && !to.velocities.empty();
  const bool is_quintic = is_cubic && !from.accelerations.empty() && !to.accelerations.empty();
  const double t = to.time - from.time;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const double p = from.positions[i];
    const double d = to.positions[i] - p;
    if (!is_cubic) {
      joints_[i] = {p, d, 0, 0, 0, 0};
      continue;
    }
    const double v = from.velocities[i] * t;
    const double w = to.velocities[i] * t;
    if (!is_quintic) {
      joints_[i] = {p, v, 3 * d - 2 * v - w, -2 * d + v + w, 0, 0};
      continue;
    }
    const double a = from.accelerations[i] * t * t;
    const double b = to.accelerations[i] * t * t;
    joints_[i] = {p,
                  v,
                  a / 2,
                  10 * d - 6 * v - 4 * w - 1.5 * a + b / 2,
                  -15 * d + 8 * v + 7 * w + 1.5 * a - b,
                  6 * d - 3 * v - 3 * w - a / 2 + b / 2};
  }
}

std::vector<double> JointMotion::at(double share) const {
  std::vector<double> values;
  for (const Polynomial& c : joints_) {
    double value = 0;
    for (int k = kOrders; k-- > 0;)
      value = value * share + c[static_cast<std::size_t>(k)];
    values.push_back(value);
  }
  return values;
}

/// The Taylor series around `share`, each term at its largest.
double JointMotion::spread(std::size_t joint, double share, double half) const {
  Polynomial c = joints_[joint];
  // A joint at rest has no spread, not even that of rounding.
  if (std::all_of(c.begin() + 1, c.end(), [](double x) { return x == 0; })) return 0;
  double size = 0;
  for (const double coefficient : c)
    size += std::abs(coefficient);
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {  // repeated Horner's scheme: Taylor coefficients
                                                    // at `share`
    for (std::size_t j = c.size() - 1; j-- > k;)
      c[j] += share * c[j + 1];
  }
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 1;)
    sum = (sum + std::abs(c[k])) * half;
  return sum * (1 + kFormulaRounding) + kFormulaRounding * size;
}

std::vector<Limits> JointMotion::ranges(const std::vector<Limits>& others) const {
  const std::vector<double> middle = at(0.5);
  std::vector<Limits> result;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const double width = spread(i, 0.5, 0.5);
    const Limits own{middle[i] - width, middle[i] + width};
    const Limits other = others.empty() ? own : others[i];
    result.push_back({std::min(other.lower, own.lower), std::max(other.upper, own.upper)});
  }
  return result;
}

bool JointMotion::isFinite() const {
  const std::vector<Limits> all = ranges();
  return std::all_of(all.begin(), all.end(), [](const Limits& range) {
    return std::isfinite(range.lower) && std::isfinite(range.upper);
  });
}

}  // namespace link_bounds
