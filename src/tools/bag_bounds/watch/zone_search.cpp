// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Halves the time until the box around both ends, with the bulge between them, is clear of the
// zone, or a pose is in it.
#include "tools/bag_bounds/watch/zone_search.h"

#include <algorithm>

#include "world/history/motion_walk.h"

namespace link_bounds {
namespace {

constexpr int kMaxPosesInZone = 20'000;        // of one motion: 20 ms
constexpr std::int64_t kCrossing = 1'000'000;  // ns, max interval of a crossing

class StaySearch {
 public:
  struct Made {
    Aabb box;
    double distance;  ///< from the zone
  };
  using Placed = BodyAtTime<Made>;

  StaySearch(const BodyMotion& motion, const Aabb& zone, double wanted)
      : motion_(motion), zone_(zone), wanted_(wanted) {}

  std::optional<Made> make(std::int64_t time, const Eigen::Affine3d& target_from_source) {
    ++poses_;
    Eigen::Affine3d pose = target_from_source;
    if (motion_.view_from_target) pose = *motion_.view_from_target * pose;
    if (motion_.source_from_link) pose = pose * *motion_.source_from_link;
    const std::optional<Aabb> box = linkBox(*motion_.link, pose);
    if (!box) return std::nullopt;
    const double distance = signedDistance(*box, zone_);
    if (distance < found_.nearest) {
      found_.nearest = distance;
      found_.nearest_stamp = time;
    }
    return Made{*box, distance};
  }

  bool isCovered(const Placed& from, const Placed& to, const Bulge& bulge) {
    const bool was_inside = from.made->distance <= 0, is_inside = to.made->distance <= 0;
    const std::int64_t duration = to.time - from.time;
    if (was_inside && is_inside) return true;
    if (was_inside != is_inside) {
      if (duration > kCrossing && poses_ < kMaxPosesInZone) return false;
      found_.crossings.push_back({is_inside, from.time, to.time});
      return true;
    }
    const Aabb bound = padded(from.made->box.merged(to.made->box), bulge.smooth + bulge.jump);
    const double clearance = signedDistance(bound, zone_);
    const bool is_clear =
        clearance > std::min(wanted_, std::max(found_.nearest - kZoneAccuracy, 0.0));
    if (!is_clear && duration > kTimeResolution && poses_ < kMaxPosesInZone) return false;
    if (!is_clear && clearance <= 0) found_.undecided = "it came nearer than can be decided";
    found_.clearance = std::min(found_.clearance, std::max(clearance, 0.0));
    return true;
  }

  ZoneSearch take() {
    if (found_.nearest <= 0 && found_.crossings.empty())
      found_.crossings = {{true, motion_.span.begin, found_.nearest_stamp}};
    if (!found_.crossings.empty() || !found_.undecided.empty()) found_.clearance = 0;
    found_.clearance = std::min(found_.clearance, std::max(found_.nearest, 0.0));
    return std::move(found_);
  }

 private:
  const BodyMotion& motion_;
  const Aabb& zone_;
  double wanted_;
  int poses_ = 0;
  ZoneSearch found_;
};

}  // namespace

ZoneSearch undecidedZone(const std::string& why) {
  ZoneSearch result;
  result.clearance = 0;
  result.undecided = why;
  return result;
}

ZoneSearch searchZone(const TransformBuffer& tf, const BodyMotion& motion, const Aabb& zone,
                      double wanted, const std::function<bool()>& gives_up) {
  MotionPath path = pathBetween(tf, motion.target, motion.source, motion.span, kNoTimeout);
  if (!path.problem.empty()) return undecidedZone(path.problem);
  StaySearch search(motion, zone, wanted);
  MotionWalk<StaySearch> walk(path, motion.span, radiusOf(motion), search, gives_up);
  if (walk.walk()) return search.take();
  return undecidedZone(walk.wasGivenUp() ? "it was interrupted" : "a pose is not finite");
}

}  // namespace link_bounds
