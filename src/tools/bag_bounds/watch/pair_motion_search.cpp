// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/watch/pair_motion_search.h"

#include <algorithm>
#include <limits>

#include "tools/bag_bounds/watch/zone_search.h"
#include "world/history/motion_walk.h"

namespace link_bounds {
namespace {

constexpr int kMaxPosesOfPair = 5'000;            // of one motion: some 100 ms
constexpr std::size_t kMaxStepsOfPair = 100'000;  // as in scene_distances.cpp
constexpr double kFarAway = std::numeric_limits<double>::infinity();

Eigen::Affine3d withOffset(const Eigen::Affine3d& pose, const Eigen::Affine3d* offset) {
  return offset ? pose * *offset : pose;
}

/// Halves the time until the distances at both ends of a piece outweigh the way between them.
class PairWalker {
 public:
  struct Made {
    Eigen::Affine3d pose;
    double distance;
  };
  using Placed = BodyAtTime<Made>;

  PairWalker(const FramedBody& first, const FramedBody& second, double wanted, double limit)
      : first_(first), second_(second), wanted_(wanted), limit_(limit) {}

  std::optional<Made> make(std::int64_t time, const Eigen::Affine3d& first_from_second) {
    ++poses_;
    const auto found =
        distanceOf(first_, Eigen::Affine3d::Identity(), second_, first_from_second, kFarAway);
    if (!found) return std::nullopt;
    if (found->lower < nearest_) {
      nearest_ = found->lower;
      stamp_ = time;
    }
    return Made{first_from_second, found->lower};
  }

  /// For a point at distance r from the origin, the chord is at most that of the origin plus r
  /// times that of the rotation, which is the Frobenius norm of its change over the root of 2.
  bool isCovered(const Placed& from, const Placed& to, const Bulge& bulge) {
    const Eigen::Affine3d& a = from.made->pose;
    const Eigen::Affine3d& b = to.made->pose;
    const double chord = (b.translation() - a.translation()).norm() +
                         0.70711 * (b.linear() - a.linear()).norm() * second_.radius;
    const double clearance =
        (from.made->distance + to.made->distance - chord) / 2 - bulge.smooth - bulge.jump;
    const bool is_clear = clearance > wanted();
    // In contact there is nothing more to find.
    if (!is_clear && nearest_ > 0 && to.time - from.time > kTimeResolution &&
        poses_ < kMaxPosesOfPair)
      return false;
    is_undecided_ |= !is_clear && nearest_ > 0;
    clearance_ = std::min(clearance_, std::max(clearance, 0.0));
    return true;
  }

  double clearance() const { return std::min(clearance_, nearest_); }
  bool isUndecided() const { return is_undecided_; }
  std::int64_t stamp() const { return stamp_; }

 private:
  /// Once a pose is below the limit, a clearance just below the nearest pose is enough, too.
  double wanted() const {
    if (nearest_ >= limit_) return wanted_;
    return std::min(wanted_, std::max(nearest_ - kPairAccuracy, 0.0));
  }

  const FramedBody& first_;
  const FramedBody& second_;
  double wanted_;
  double limit_;
  double clearance_ = kFarAway;
  double nearest_ = kFarAway;
  std::int64_t stamp_ = 0;
  int poses_ = 0;
  bool is_undecided_ = false;
};

}  // namespace

std::optional<BodyDistance> distanceOf(const FramedBody& first, const Eigen::Affine3d& first_pose,
                                       const FramedBody& second, const Eigen::Affine3d& second_pose,
                                       double limit) {
  return bodyDistance(*first.body, withOffset(first_pose, first.offset), *second.body,
                      withOffset(second_pose, second.offset),
                      {kPairAccuracy / 10, limit, kMaxStepsOfPair});
}

PairFinding searchPair(const TransformBuffer& tf, const FramedBody& first, const FramedBody& second,
                       MotionSpan span, double wanted, double limit,
                       const std::function<bool()>& gives_up) {
  MotionPath path = pathBetween(tf, first.frame, second.frame, span, kNoTimeout);
  if (!path.problem.empty()) return {0, std::nullopt, path.problem};
  PairWalker walker(first, second, wanted, limit);
  MotionWalk<PairWalker> walk(path, span, second.radius, walker, gives_up);
  if (!walk.walk())
    return {0, std::nullopt, walk.wasGivenUp() ? "it was interrupted" : "a pose is not finite"};
  return {walker.clearance(), walker.stamp(),
          walker.isUndecided() ? "they came nearer than can be decided" : ""};
}

}  // namespace link_bounds
