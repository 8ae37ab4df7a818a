// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes boxes at all samples, and between samples until no face lies too far outside.
#include "world/history/swept_box.h"

#include <cmath>

#include "world/history/motion_walk.h"

namespace link_bounds {
namespace {

/// Max distance by which a face may lie too far outside [m]. A side is longer by up to twice this.
constexpr double kSmoothTolerance = 4e-4;

/// Max number of poses between samples, about half a second of work. If it is reached, the box is
/// larger than necessary.
constexpr int kMaxPoses = 1000000;

constexpr const char* kNotFinite = "a pose is not finite, or too large for a box";

/// The box around all boxes of one link on its way, and the margins between them.
class Hull {
 public:
  using Made = Aabb;
  using Placed = BodyAtTime<Made>;

  explicit Hull(const BoundedLink& link) : link_(link) {}

  /// Extends the hull at once, because most motions between samples stay in the boxes at samples.
  std::optional<Aabb> make(std::int64_t, const Eigen::Affine3d& target_from_link) {
    std::optional<Aabb> box = linkBox(link_, target_from_link);
    if (box) hull_.extend(*box);
    return box;
  }

  bool isCovered(const Placed& from, const Placed& to, const Bulge& bulge) {
    const Aabb bound = padded(from.made->merged(*to.made), bulge.smooth + bulge.jump);
    const bool is_covered = bulge.smooth <= kSmoothTolerance || hull_.contains(bound) ||
                            to.time - from.time < 2 || poses_ == kMaxPoses;
    if (is_covered) {
      hull_.extend(bound);
    } else {
      ++poses_;
    }
    return is_covered;
  }

  const Aabb& box() const { return hull_; }

 private:
  const BoundedLink& link_;
  Aabb hull_;
  int poses_ = 0;  ///< number of poses between samples
};

}  // namespace

double radiusOf(const BoundedLink& link) {
  return std::sqrt(3) * magnitude(link);
}

SweptBox sweptBox(const TransformBuffer& tf, TransformBuffer::Frame target,
                  TransformBuffer::Frame source, MotionSpan span, const BoundedLink& link,
                  double timeout, const std::function<bool()>& gives_up) {
  if (link.shapes.empty()) return {std::nullopt, "the link has no geometry"};
  MotionPath path = pathBetween(tf, target, source, span, timeout);
  if (!path.problem.empty()) return {std::nullopt, path.problem};
  Hull hull(link);
  MotionWalk<Hull> walk(path, span, radiusOf(link), hull, gives_up);
  if (walk.walk()) return {hull.box(), ""};
  return {std::nullopt, walk.wasGivenUp() ? kNotInTime : kNotFinite};
}

}  // namespace link_bounds
