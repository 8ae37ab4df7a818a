// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A coordinate search whose steps become smaller.
#include "robot/reach/attained_pose.h"

#include <algorithm>

namespace link_bounds {
namespace {

/// Steps of a variable [rad or m]. A face is off by about the square of the last step.
constexpr double kLargestStep = 0.1;
constexpr double kSmallestStep = 1e-7;

/// A round of steps that gains less than this is the last one of its size [m]. Otherwise the search
/// would creep for ever where a direction is almost level.
constexpr double kMinGain = 1e-8;

/// Tries one step; returns whether the face moved outward.
bool improve(const JointPath& chain, const BoundedLink& link, std::size_t face,
             std::size_t variable, double step, AttainedFace& best) {
  const auto [lower, upper] = chain.ranges[variable];
  const double old = best.values[variable];
  best.values[variable] = std::min(std::max(old + step, lower), upper);
  if (best.values[variable] != old) {
    const double at = faceAt(chain, link, face, best.values);
    if (beyond(face, at, best.at) > 0) {
      best.at = at;
      return true;
    }
  }
  best.values[variable] = old;
  return false;
}

}  // namespace

double faceAt(const JointPath& chain, const BoundedLink& link, std::size_t face,
              const std::vector<double>& values) {
  return faceOf(*linkBox(link, Eigen::Affine3d(chain.pose(values))), face);
}

AttainedFace attainedFrom(const JointPath& chain, const BoundedLink& link, std::size_t face,
                          std::vector<double> start, const Stop& stop) {
  AttainedFace best{faceAt(chain, link, face, start), std::move(start)};
  for (double step = kLargestStep; step > kSmallestStep && !stop();) {
    const double before = best.at;
    for (std::size_t variable = 0; variable < chain.variables.size(); ++variable) {
      if (!improve(chain, link, face, variable, step, best))
        improve(chain, link, face, variable, -step, best);
    }
    if (beyond(face, best.at, before) < kMinGain) step /= 2;
  }
  return best;
}

}  // namespace link_bounds
