// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A body on its way: placed at all samples of all edges of the path, and between them as often as
// the visitor needs it, with the bound of deviation_bound.h.
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
struct PlacedBody {
  std::int64_t time;
  std::optional<Made> made;  ///< what the visitor made of the pose; nothing if that failed
  double distance;           ///< of its origin from that of the target [m]
};

/// A Visitor has
///   using Made = ...;
///   std::optional<Made> make(std::int64_t time, const Eigen::Affine3d& target_from_body);
///   /// No point of the body leaves the straight way between its two places by more than `bulge`,
///   /// whose sum is finite. False halves the time between them; not allowed below 2 ns.
///   bool isCovered(const PlacedBody<Made>& from, const PlacedBody<Made>& to, const Bulge& bulge);
template <class Visitor>
class MotionWalk {
 public:
  using Placed = PlacedBody<typename Visitor::Made>;

  /// `radius`: how far the points of the body are from its origin [m], at most. All must outlive
  /// this.
  MotionWalk(MotionPath& path, MotionSpan span, double radius, Visitor& visitor,
             const std::function<bool()>& gives_up)
      : path_(path), radius_(radius), visitor_(visitor), gives_up_(gives_up) {
    times_ = {span.begin};
    for (const auto* edges : {&path.from_source, &path.from_target}) {
      for (const EdgeMotion& edge : *edges)
        addTimes(edge, span);
    }
    if (isMoving()) times_.push_back(span.end);
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  }

  /// First the places at all samples, then all motions between them, in the order of time. False if
  /// something is not finite, or if it was given up.
  bool walk() {
    std::vector<Placed> placed;
    for (const std::int64_t time : times_) {
      seek(time);
      placed.push_back(place(time));
      if (!isUsable(placed.back())) return false;
    }
    for (std::size_t i = 0; i + 1 < placed.size(); ++i) {
      seek(times_[i]);
      if (!coverStep(placed[i], placed[i + 1])) return false;
      if (isAmbiguous() && !coverAsInLibrary(times_[i], times_[i + 1])) return false;
    }
    // The last pose needs the margin of rounding, too. A body at rest is where its pose is.
    if (times_.size() > 1 && !cover(placed.back(), placed.back())) return false;
    const std::int64_t end = times_.back();
    seek(end);
    return !isAmbiguous() || coverAsInLibrary(end, end);
  }

  bool wasGivenUp() const { return is_given_up_; }

 private:
  static constexpr int kStepsPerLook = 100;  // a tenth of a millisecond, on a path of a few edges

  void addTimes(const EdgeMotion& edge, MotionSpan span) {
    if (!edge.isMoving()) return;
    for (const EdgeSample* sample : edge.samples()) {
      if (sample->stamp > span.begin && sample->stamp < span.end) times_.push_back(sample->stamp);
    }
  }

  bool isMoving() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isMoving(); });
  }

  template <class Test>
  bool anyEdge(Test test) const {
    return std::any_of(path_.from_source.begin(), path_.from_source.end(), test) ||
           std::any_of(path_.from_target.begin(), path_.from_target.end(), test);
  }

  void seek(std::int64_t time) {
    for (auto* edges : {&path_.from_source, &path_.from_target}) {
      for (EdgeMotion& edge : *edges)
        edge.seek(time);
    }
  }

  /// The products are those of TransformBuffer::pose.
  Placed place(std::int64_t time) {
    if (isGivenUp()) return {time, std::nullopt, 0};
    Tf2Pose top_from_source, top_from_target;
    for (const EdgeMotion& edge : path_.from_source)
      top_from_source = edge.at(time) * top_from_source;
    for (const EdgeMotion& edge : path_.from_target)
      top_from_target = edge.at(time) * top_from_target;
    const Tf2Pose pose =
        path_.from_target.empty() ? top_from_source : inverse(top_from_target) * top_from_source;
    return {time, visitor_.make(time, MatrixPose(pose).affine), pose.translation().length()};
  }

  bool isGivenUp() {
    if (!is_given_up_ && ++steps_done_ % kStepsPerLook == 0) is_given_up_ = gives_up_();
    return is_given_up_;
  }

  static bool isUsable(const Placed& placed) {
    return placed.made && std::isfinite(placed.distance);
  }

  bool isAmbiguous() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isAmbiguous(); });
  }

  /// From one sample to the next, where the library moves an edge otherwise.
  bool coverAsInLibrary(std::int64_t begin, std::int64_t end) {
    followLibrary(true);
    const Placed from = place(begin), to = place(end);
    const bool is_covered = isUsable(from) && isUsable(to) && coverStep(from, to);
    followLibrary(false);
    return is_covered;
  }

  void followLibrary(bool is_library) {
    for (auto* edges : {&path_.from_source, &path_.from_target}) {
      for (EdgeMotion& edge : *edges)
        edge.followLibrary(is_library);
    }
  }

  /// From one sample to the next.
  bool coverStep(const Placed& from, Placed to) {
    if (isSudden()) {
      to = place(to.time - 1);
      if (!isUsable(to)) return false;
    }
    return cover(from, to);
  }

  /// True if an edge jumps at the next sample: its motion ends one nanosecond before.
  bool isSudden() const {
    return anyEdge([](const EdgeMotion& edge) { return edge.isSudden(); });
  }

  /// False if something is not finite, or given up.
  bool cover(const Placed& from, const Placed& to) {
    if (isGivenUp()) return false;
    const Bulge bulge = bulgeOf(from, to);
    if (!std::isfinite(bulge.smooth + bulge.jump)) return false;
    if (visitor_.isCovered(from, to, bulge)) return true;
    const Placed middle = place(from.time + (to.time - from.time) / 2);
    return isUsable(middle) && cover(from, middle) && cover(middle, to);
  }

  Bulge bulgeOf(const Placed& from, const Placed& to) {
    const auto fill = [&](const std::vector<EdgeMotion>& edges, std::vector<EdgeStep>& steps) {
      steps.clear();
      for (const EdgeMotion& edge : edges)
        steps.push_back(edge.stepIn(to.time - from.time));
    };
    fill(path_.from_source, steps_.from_link);
    fill(path_.from_target, steps_.from_target);
    return bulge(steps_, radius_, std::max(from.distance, to.distance));
  }

  MotionPath& path_;
  double radius_;
  Visitor& visitor_;
  const std::function<bool()>& gives_up_;
  std::vector<std::int64_t> times_;
  PathSteps steps_;     ///< memory that is reused
  int steps_done_ = 0;  ///< poses and steps between them
  bool is_given_up_ = false;
};

}  // namespace link_bounds
