// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes at all samples of all edges of the path, and between them as often as the bound of
// deviation_bound.h needs it.
#include "world/history/swept_box.h"

#include <algorithm>
#include <cmath>

namespace link_bounds {
namespace {

/// By how much a face may lie outside [m]; the box is longer by two of them.
constexpr double kTolerance = 4e-4;

/// No more poses than this between samples: half a second. Beyond it the box is larger.
constexpr int kMaxPoses = 1000000;

constexpr int kStepsPerLook = 100;  // a tenth of a millisecond, on a path of a few edges

constexpr const char* kNotFinite = "a pose is not finite, or too large for a box";

/// One link on its way.
class Sweep {
 public:
  Sweep(MotionPath& path, const BoundedLink& link, MotionSpan span,
        const std::function<bool()>& gives_up)
      : path_(path), link_(link), gives_up_(gives_up), radius_(std::sqrt(3) * magnitude(link)) {
    times_ = {span.begin};
    for (const auto* edges : {&path.from_source, &path.from_target}) {
      for (const EdgeMotion& edge : *edges)
        addTimes(edge, span);
    }
    if (isMoving()) times_.push_back(span.end);
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  }

  SweptBox box() {
    if (coverAll()) return {hull_, ""};
    return {std::nullopt, is_given_up_ ? kNotInTime : kNotFinite};
  }

 private:
  /// The link at one time.
  struct Placed {
    std::int64_t time;
    std::optional<Aabb> box;
    double distance;  ///< of its origin from that of the target
  };

  /// First the boxes at all samples: most motions between them are inside. False if there is no
  /// box.
  bool coverAll() {
    std::vector<Placed> placed;
    for (const std::int64_t time : times_) {
      seek(time);
      placed.push_back(place(time));
      if (!isUsable(placed.back())) return false;
    }
    for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
      seek(times_[i]);
      if (!coverStep(placed[i], placed[i + 1])) return false;
      if (isAmbiguous() && !coverAsInLibrary(times_[i], times_[i + 1])) return false;
    }
    // The last pose needs the margin of rounding, too. A link at rest has the box of its pose.
    if (times_.size() > 1 && !cover(placed.back(), placed.back())) return false;
    const std::int64_t end = times_.back();
    seek(end);
    return !isAmbiguous() || coverAsInLibrary(end, end);
  }

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
    Placed placed{time, linkBox(link_, MatrixPose(pose).affine), pose.translation().length()};
    if (placed.box) hull_.extend(*placed.box);
    return placed;
  }

  bool isGivenUp() {
    if (!is_given_up_ && ++steps_done_ % kStepsPerLook == 0) is_given_up_ = gives_up_();
    return is_given_up_;
  }

  static bool isUsable(const Placed& placed) {
    return placed.box && std::isfinite(placed.distance);
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
    const std::int64_t duration = to.time - from.time;
    const Bulge bulge = bulgeOf(from, to);
    const double margin = bulge.smooth + bulge.jump;
    if (!std::isfinite(margin)) return false;
    const Aabb bound = padded(from.box->merged(*to.box), margin);
    if (bulge.smooth <= kTolerance || hull_.contains(bound) || duration < 2 ||
        poses_ == kMaxPoses) {
      hull_.extend(bound);
      return true;
    }
    ++poses_;
    const Placed middle = place(from.time + duration / 2);
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
  const BoundedLink& link_;
  const std::function<bool()>& gives_up_;
  double radius_;
  std::vector<std::int64_t> times_;
  PathSteps steps_;  ///< memory that is reused
  Aabb hull_;
  int poses_ = 0;       ///< between samples
  int steps_done_ = 0;  ///< poses and steps between them
  bool is_given_up_ = false;
};

}  // namespace

SweptBox sweptBox(const TransformBuffer& tf, TransformBuffer::Frame target,
                  TransformBuffer::Frame source, MotionSpan span, const BoundedLink& link,
                  double timeout, const std::function<bool()>& gives_up) {
  if (link.shapes.empty()) return {std::nullopt, "the link has no geometry"};
  MotionPath path = pathBetween(tf, target, source, span, timeout);
  if (!path.problem.empty()) return {std::nullopt, path.problem};
  return Sweep(path, link, span, gives_up).box();
}

}  // namespace link_bounds
