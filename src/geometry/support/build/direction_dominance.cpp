// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Every candidate against the champions of each corner and of their sum.
#include "geometry/support/build/direction_dominance.h"

#include <algorithm>
#include <array>
#include <limits>

namespace link_bounds {
namespace {

constexpr std::size_t kMostCorners = 6;  ///< of two triangles

/// How far a point reaches at each corner; corners that do not exist are 0.
using Reaches = std::array<double, kMostCorners>;

Reaches reachesOf(const Eigen::Vector3d& point, const Cone& corners, double sign) {
  Reaches reaches{};
  for (std::size_t i = 0; i < corners.size(); ++i)
    reaches[i] = sign * point.dot(corners[i]);
  return reaches;
}

/// Of the candidates so far, those that reach farthest at one corner or at all of them on average.
class Champions {
 public:
  explicit Champions(std::size_t corners) : corners_(corners), best_(corners + 1) {
    for (Reaches& reaches : best_)
      reaches.fill(-std::numeric_limits<double>::infinity());
  }

  void add(const Reaches& reaches) {
    double sum = 0;
    for (std::size_t i = 0; i < corners_; ++i) {
      sum += reaches[i];
      if (reaches[i] > best_[i][i]) best_[i] = reaches;
    }
    if (sum > best_sum_) best_.back() = reaches;
    best_sum_ = std::max(best_sum_, sum);
  }

  /// True if one of them is ahead of the candidate by more than the margin at every corner.
  bool beat(const Reaches& reaches, double margin) const {
    return std::any_of(best_.begin(), best_.end(), [&](const Reaches& best) {
      for (std::size_t i = 0; i < corners_; ++i) {
        if (!(best[i] - reaches[i] > margin)) return false;
      }
      return true;
    });
  }

 private:
  std::size_t corners_;
  std::vector<Reaches> best_;
  double best_sum_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

void dropDominated(const std::vector<Eigen::Vector3d>& points, const Cone& corners, double sign,
                   double margin, PointIndices& candidates) {
  std::vector<Reaches> reaches;
  reaches.reserve(candidates.size());
  Champions champions(corners.size());
  for (const std::uint32_t candidate : candidates) {
    reaches.push_back(reachesOf(points[candidate], corners, sign));
    champions.add(reaches.back());
  }
  std::size_t left = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!champions.beat(reaches[i], margin)) candidates[left++] = candidates[i];
  }
  candidates.resize(left);
}

}  // namespace link_bounds
