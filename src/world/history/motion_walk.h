// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Follows a moving body: places it at all samples of all edges of its path, and between them as
// often as the visitor requires, and bounds the motion by deviation_bound.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "world/history/motion_path.h"

namespace link_bounds {

/// The body at one time.
template <class Made>
struct BodyAtTime {
  std::int64_t time;
  std::optional<Made> made;  ///< result of Visitor::make(); nothing if that failed
  double distance;           ///< between the origins of body and target [m]
};

/// A Visitor has
///   using Made = ...;
///   std::optional<Made> make(std::int64_t time, const Eigen::Affine3d& target_from_body);
///   /// No point of the body leaves the straight way between its two places by more than `bulge`,
///   /// whose sum is finite. If this returns false, the walk halves the interval. It must return
///   /// true for intervals shorter than 2 ns.
///   bool isCovered(const BodyAtTime<Made>& from, const BodyAtTime<Made>& to, const Bulge& bulge);
template <class Visitor>
class MotionWalk {
 public:
  using Placed = BodyAtTime<typename Visitor::Made>;

  /// `radius`: max distance of the points of the body from its origin [m]. All references must
  /// outlive this.
  MotionWalk(MotionPath& path, MotionSpan span, double radius, Visitor& visitor,
             const std::function<bool()>& gives_up)
      : path_(path), radius_(radius), visitor_(visitor), gives_up_(gives_up) {
    times_ = {span.begin};
    path.addSampleTimes(span, times_);
    if (path.isMoving()) times_.push_back(span.end);
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  }

  /// Places the body at all samples, then covers the motions between them in the order of time.
  /// False if a pose or a bound is not finite, if make() failed, or if `gives_up` returned true.
  bool walk() {
    std::vector<Placed> placed;
    for (const std::int64_t time : times_) {
      path_.seek(time);
      placed.push_back(place(time));
      if (!isUsable(placed.back())) return false;
    }
    for (std::size_t i = 0; i + 1 < placed.size(); ++i) {
      path_.seek(times_[i]);
      if (!coverStep(placed[i], placed[i + 1])) return false;
      if (path_.isAmbiguous() && !coverAsInLibrary(times_[i], times_[i + 1])) return false;
    }
    // The last pose needs the margin for rounding, too. A body at rest needs none.
    if (times_.size() > 1 && !cover(placed.back(), placed.back())) return false;
    const std::int64_t end = times_.back();
    path_.seek(end);
    return !path_.isAmbiguous() || coverAsInLibrary(end, end);
  }

  bool wasGivenUp() const { return is_given_up_; }

 private:
  static constexpr int kStepsPerLook = 100;  // 0.1 ms between calls of gives_up, for a few edges

  Placed place(std::int64_t time) {
    if (isGivenUp()) return {time, std::nullopt, 0};
    const Tf2Pose pose = path_.targetFromSource(time);
    return {time, visitor_.make(time, MatrixPose(pose).affine), pose.translation().length()};
  }

  bool isGivenUp() {
    if (!is_given_up_ && ++steps_done_ % kStepsPerLook == 0) is_given_up_ = gives_up_();
    return is_given_up_;
  }

  static bool isUsable(const Placed& placed) {
    return placed.made && std::isfinite(placed.distance);
  }

  /// As coverStep(), with edges as the tf2 library moves them: see EdgeMotion::isAmbiguous().
  bool coverAsInLibrary(std::int64_t begin, std::int64_t end) {
    path_.followLibrary(true);
    const Placed from = place(begin), to = place(end);
    const bool is_covered = isUsable(from) && isUsable(to) && coverStep(from, to);
    path_.followLibrary(false);
    return is_covered;
  }

  /// Covers the motion from one sample to the next.
  bool coverStep(const Placed& from, Placed to) {
    if (path_.isSudden()) {
      to = place(to.time - 1);
      if (!isUsable(to)) return false;
    }
    return cover(from, to);
  }

  /// Covers the motion between two places. Fails as walk() does.
  bool cover(const Placed& from, const Placed& to) {
    if (isGivenUp()) return false;
    const Bulge bulge = bulgeOf(from, to);
    if (!std::isfinite(bulge.smooth + bulge.jump)) return false;
    if (visitor_.isCovered(from, to, bulge)) return true;
    const Placed middle = place(from.time + (to.time - from.time) / 2);
    return isUsable(middle) && cover(from, middle) && cover(middle, to);
  }

  Bulge bulgeOf(const Placed& from, const Placed& to) {
    fillSteps(path_.from_source, to.time - from.time, steps_.from_link);
    fillSteps(path_.from_target, to.time - from.time, steps_.from_target);
    return bulge(steps_, radius_, std::max(from.distance, to.distance));
  }

  MotionPath& path_;
  double radius_;
  Visitor& visitor_;
  const std::function<bool()>& gives_up_;
  std::vector<std::int64_t> times_;
  PathSteps steps_;     ///< memory that is reused
  int steps_done_ = 0;  ///< poses made and motions bounded
  bool is_given_up_ = false;
};

}  // namespace link_bounds
