// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Clipping of cones (Sutherland and Hodgman) and the search for witnesses.
#include "direction_envelope.h"

#include <algorithm>

namespace link_bounds {
namespace {

Eigen::Vector3d middle(const Cone& cone) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& edge : cone)
    sum += edge;
  return sum / static_cast<double>(cone.size());
}

}  // namespace

void Envelope::appendNeeded(const PointIndices& candidates, const Cone& cone, double sign,
                            PointIndices& needed) {
  kept_.clear();
  keep(farthest(candidates, sign * middle(cone)));
  for (const Eigen::Vector3d& edge : cone)
    keep(farthest(candidates, sign * edge));
  for (const std::uint32_t point : candidates)
    decide(point, candidates, cone, sign);
  needed.insert(needed.end(), kept_.begin(), kept_.end());
}

std::uint32_t Envelope::farthest(const PointIndices& candidates,
                                 const Eigen::Vector3d& direction) const {
  std::uint32_t best = candidates.front();
  double height = points_[best].dot(direction);
  for (const std::uint32_t candidate : candidates) {
    const double other = points_[candidate].dot(direction);
    if (other > height) {
      height = other;
      best = candidate;
    }
  }
  return best;
}

/// False if the point was kept before.
bool Envelope::keep(std::uint32_t point) {
  if (std::find(kept_.begin(), kept_.end(), point) != kept_.end()) return false;
  kept_.push_back(point);
  return true;
}

void Envelope::decide(std::uint32_t point, const PointIndices& candidates, const Cone& cone,
                      double sign) {
  if (std::find(kept_.begin(), kept_.end(), point) != kept_.end()) return;
  region_ = cone;
  if (!clipByKept(point, sign)) return;
  for (;;) {
    const std::uint32_t best = farthest(candidates, sign * middle(region_));
    // A point that ties with a kept one to within rounding is as good as that.
    if (best == point || !keep(best)) {
      keep(point);
      return;
    }
    if (!clip(sign * (points_[point] - points_[best]))) return;
  }
}

bool Envelope::clipByKept(std::uint32_t point, double sign) {
  for (std::size_t i = kept_.size(); i-- > 0;) {
    if (!clip(sign * (points_[point] - points_[kept_[i]]))) return false;
  }
  return true;
}

/// Cuts the region down to where normal . d > tolerance; false if nothing is left.
bool Envelope::clip(const Eigen::Vector3d& normal) {
  heights_.clear();
  bool any_above = false;
  bool any_below = false;
  for (const Eigen::Vector3d& edge : region_) {
    heights_.push_back(normal.dot(edge) - tolerance_);
    (heights_.back() > 0 ? any_above : any_below) = true;
  }
  if (!any_above) return false;
  if (!any_below) return true;
  clipped_.clear();
  for (std::size_t i = 0, last = region_.size() - 1; i < region_.size(); last = i++) {
    const double before = heights_[last];
    const double here = heights_[i];
    if ((before > 0) != (here > 0)) {
      const double portion = before / (before - here);
      clipped_.push_back(region_[last] + portion * (region_[i] - region_[last]));
    }
    if (here > 0) clipped_.push_back(region_[i]);
  }
  region_.swap(clipped_);
  return true;
}

}  // namespace link_bounds
