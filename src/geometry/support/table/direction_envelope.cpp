// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Clipping of cones (Sutherland and Hodgman) and the search for witnesses.
#include "geometry/support/table/direction_envelope.h"

#include <algorithm>
#include <array>

namespace link_bounds {
namespace {

/// A cone with more than kContenders candidates is halved, and so are its halves, to a depth of
/// kDeepest, until each candidate has been examined kLooks times on average. That is enough to
/// reach the strip by which cells are enlarged. Without these limits ties would halve cones without
/// end: 2^depth cones for ties along a line of directions, nested ones for ties at one direction.
/// With 12 contenders, the tables of robots take 1.2 times as many instructions, and with 192, so
/// does the table of a sphere. With 16 looks, the table of a polygon of 2,000 corners takes 1.7
/// times as many.
constexpr std::size_t kContenders = 48;
constexpr int kDeepest = 40;
constexpr std::size_t kLooks = 64;

/// How many points Effort::kQuick compares the others with. The four corners of a plate, for
/// example, beat all its other points. With 24, the table of a ball of 600,000 points takes 1.4
/// times as long.
constexpr std::size_t kQuicklyKept = 6;

Eigen::Vector3d middle(const Cone& cone) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& edge : cone)
    sum += edge;
  return sum / static_cast<double>(cone.size());
}

/// Cuts a cone of three or four edges through the middle of its longest side.
std::array<Cone, 2> halves(const Cone& cone) {
  const std::size_t count = cone.size();
  std::size_t longest = 0;
  const auto length = [&](std::size_t i) { return (cone[(i + 1) % count] - cone[i]).norm(); };
  for (std::size_t i = 1; i < count; ++i) {
    if (length(i) > length(longest)) longest = i;
  }
  const auto edge = [&](std::size_t i) { return cone[(longest + i) % count]; };
  const Eigen::Vector3d cut = (edge(0) + edge(1)) / 2;
  if (count == 3) return {Cone{cut, edge(1), edge(2)}, Cone{cut, edge(2), edge(0)}};
  const Eigen::Vector3d opposite = (edge(2) + edge(3)) / 2;
  return {Cone{cut, edge(1), edge(2), opposite}, Cone{cut, opposite, edge(3), edge(0)}};
}

}  // namespace

PointIndices Envelope::neededOf(const PointIndices& candidates, const std::vector<Cone>& cones,
                                double sign) {
  sign_ = sign;
  is_needed_.resize(points_.size());
  needed_.clear();
  for (const Cone& cone : cones)
    begin(candidates, cone);
  for (const std::uint32_t point : needed_)
    is_needed_[point] = false;
  std::sort(needed_.begin(), needed_.end());
  return needed_;
}

void Envelope::begin(const PointIndices& candidates, const Cone& cone) {
  const PointIndices left = beyondChampions(candidates, cone);
  if (effort_ == Effort::kQuick) return searchQuickly(left, cone);
  looks_ = kLooks * left.size();
  search(left, cone, 0);
}

/// Decides as searchAll() until a few points are kept, and then keeps all points that these do not
/// beat.
void Envelope::searchQuickly(const PointIndices& candidates, const Cone& cone) {
  for (const std::uint32_t point : candidates) {
    if (is_needed_[point]) continue;
    if (kept_.size() < kQuicklyKept) {
      decide(point, candidates, cone);
      continue;
    }
    region_ = cone;
    if (!clipByKept(point)) continue;
    is_needed_[point] = true;
    needed_.push_back(point);
  }
}

void Envelope::search(const PointIndices& candidates, const Cone& cone, int depth) {
  const bool is_decided = std::all_of(candidates.begin(), candidates.end(),
                                      [this](std::uint32_t point) { return is_needed_[point]; });
  if (is_decided) return;
  if (candidates.size() > kContenders && candidates.size() <= looks_ && depth < kDeepest) {
    searchHalves(candidates, cone, depth + 1);
  } else {
    searchAll(candidates, cone);
  }
}

/// The half with fewer candidates first: a point that is needed there needs no decision in the
/// other half.
void Envelope::searchHalves(const PointIndices& candidates, const Cone& cone, int depth) {
  looks_ -= candidates.size();
  const std::array<Cone, 2> half = halves(cone);
  std::array<PointIndices, 2> left{candidates, candidates};
  for (const std::size_t i : {0u, 1u})
    dropDominated(points_, half[i], sign_, tolerance_, left[i]);
  const std::size_t first = left[0].size() <= left[1].size() ? 0 : 1;
  search(left[first], half[first], depth);
  search(left[1 - first], half[1 - first], depth);
}

void Envelope::searchAll(const PointIndices& candidates, const Cone& cone) {
  keepChampions(candidates, cone);
  for (const std::uint32_t point : candidates) {
    if (!is_needed_[point]) decide(point, candidates, cone);
  }
}

void Envelope::keepChampions(const PointIndices& candidates, const Cone& cone) {
  kept_.clear();
  keep(farthest(candidates, middle(cone)));
  for (const Eigen::Vector3d& edge : cone)
    keep(farthest(candidates, edge));
}

/// Drops, before cones are halved, the points that a few others beat together, such as those inside
/// flat faces.
PointIndices Envelope::beyondChampions(const PointIndices& candidates, const Cone& cone) {
  keepChampions(candidates, cone);
  PointIndices left;
  for (const std::uint32_t point : candidates) {
    region_ = cone;
    if (is_needed_[point] || clipByKept(point)) left.push_back(point);
  }
  return left;
}

std::uint32_t Envelope::farthest(const PointIndices& candidates,
                                 const Eigen::Vector3d& direction) const {
  meter_.add(candidates.size());
  std::uint32_t best = candidates.front();
  double height = sign_ * points_[best].dot(direction);
  for (const std::uint32_t candidate : candidates) {
    const double other = sign_ * points_[candidate].dot(direction);
    if (other > height) {
      height = other;
      best = candidate;
    }
  }
  return best;
}

/// Keeps a point as needed in this cone. False if it was kept in this cone before.
bool Envelope::keep(std::uint32_t point) {
  if (std::find(kept_.begin(), kept_.end(), point) != kept_.end()) return false;
  kept_.push_back(point);
  if (!is_needed_[point]) needed_.push_back(point);
  is_needed_[point] = true;
  return true;
}

void Envelope::decide(std::uint32_t point, const PointIndices& candidates, const Cone& cone) {
  region_ = cone;
  if (!clipByKept(point)) return;
  for (;;) {
    const std::uint32_t best = farthest(candidates, middle(region_));
    // If `best` is kept already, the point ties with it to within rounding, and is kept, too.
    if (best == point || !keep(best)) {
      keep(point);
      return;
    }
    if (!clip(point, best)) return;
  }
}

bool Envelope::clipByKept(std::uint32_t point) {
  meter_.add(kept_.size());
  for (std::size_t i = kept_.size(); i-- > 0;) {
    if (!clip(point, kept_[i])) return false;
  }
  return true;
}

/// Cuts the region down to where the point beats the other; false if nothing is left.
bool Envelope::clip(std::uint32_t point, std::uint32_t other) {
  const Eigen::Vector3d normal = sign_ * (points_[point] - points_[other]);
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
