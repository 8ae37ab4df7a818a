// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The second body moves in the frame of the first one.
#include "tools/bag_bounds/watch/pair_motions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tools/bag_bounds/watch/zone_search.h"
#include "world/history/motion_walk.h"
#include "world/history/swept_box.h"

namespace link_bounds {
namespace {

constexpr int kMaxPosesOfPair = 5'000;      // of one motion: some 100 ms
constexpr std::size_t kMaxSteps = 100'000;  // as in scene_distances.cpp
constexpr double kInfinite = std::numeric_limits<double>::infinity();

Eigen::Affine3d with(const Eigen::Affine3d& pose, const Eigen::Affine3d* offset) {
  return offset ? pose * *offset : pose;
}

std::optional<BodyDistance> measure(const MovedBody& first, const Eigen::Affine3d& first_pose,
                                    const MovedBody& second, const Eigen::Affine3d& second_pose,
                                    double limit) {
  return bodyDistance(*first.body, with(first_pose, first.offset), *second.body,
                      with(second_pose, second.offset), {kPairAccuracy / 10, limit, kMaxSteps});
}

/// Halves the time until the way of a piece is shorter than the distances at its ends allow.
class PairMotionSearch {
 public:
  struct Made {
    Eigen::Affine3d pose;
    double distance;
  };
  using Placed = BodyAtTime<Made>;

  PairMotionSearch(const MovedBody& first, const MovedBody& second, double wanted, double limit)
      : first_(first), second_(second), wanted_(wanted), limit_(limit) {}

  std::optional<Made> make(std::int64_t time, const Eigen::Affine3d& first_from_second) {
    ++poses_;
    const auto found =
        measure(first_, Eigen::Affine3d::Identity(), second_, first_from_second, kInfinite);
    if (!found) return std::nullopt;
    if (found->lower < nearest_) {
      nearest_ = found->lower;
      stamp_ = time;
    }
    return Made{first_from_second, found->lower};
  }

  /// Of a point at a distance of r from the origin, the chord is at most the origin's and r times
  /// that of the rotation, which is its Frobenius norm over the root of 2.
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
  /// While no pose is below the limit, none between two poses may be, either.
  double wanted() const {
    if (nearest_ >= limit_) return wanted_;
    return std::min(wanted_, std::max(nearest_ - kPairAccuracy, 0.0));
  }

  const MovedBody& first_;
  const MovedBody& second_;
  double wanted_;
  double limit_;
  double clearance_ = kInfinite;
  double nearest_ = kInfinite;
  std::int64_t stamp_ = 0;
  int poses_ = 0;
  bool is_undecided_ = false;
};

}  // namespace

void PairMotions::look(const MomentPtr& moment, MomentPairs& pairs, const LiveBodies& bodies,
                       const TransformBuffer& tf, const Handlers& handlers) {
  begin(moment, tf);
  double way = 0;
  for (const MovedBody& mover : movers_)
    way = std::max(way, mover.way);
  if (way > 0) {
    const double margin = moment->model->parameters.distance_limit + 2 * way;
    std::vector<BoxPair> near;
    pairs.read(
        moment, std::isfinite(margin) ? margin : 1e30,
        [&near](const NearPairs& found) { near = found.compared; }, handlers.gives_up);
    for (const BoxPair& pair : near) {
      if (handlers.gives_up()) break;
      lookAt(pair, bodies, tf, handlers);
    }
  }
  for (auto lease = leases_.begin(); lease != leases_.end();)
    lease = lease->second.first == pass_ ? std::next(lease) : leases_.erase(lease);
}

void PairMotions::begin(const MomentPtr& moment, const TransformBuffer& tf) {
  ++pass_;
  moment_ = moment;
  movers_.clear();
  for (const Moment::Body& body : moment->bodies) {
    MovedBody mover = moverOf(body, tf);
    mover.end = !body.object || body.object->follows() ? body.stamp : 0;
    movers_.push_back(mover);
  }
  findBegins(*moment);
  forgetObjects();
  if (!edges_) edges_.emplace(tf);
  const auto fixed = tf.find(moment->model->fixed_frame);
  if (fixed) findWays(ways_.try_emplace(*fixed, *edges_, *fixed).first->second);
}

/// Remembers the stamps of this moment for the next ones.
void PairMotions::findBegins(const Moment& moment) {
  const double timeout = moment.model->parameters.timeout;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Moment::Body& body = moment.bodies[i];
    MovedBody& mover = movers_[i];
    const BodyKey key{body.link ? *body.link + 1 : 0, body.object};
    const auto [last, is_new] = stamps_.try_emplace(key, 0);
    const std::int64_t before = std::exchange(last->second, body.stamp);
    if (is_new) continue;
    mover.begin = mover.end == 0 ? 0 : before;
    const std::int64_t passed = mover.end - mover.begin;
    mover.was_there =
        passed == 0 || (mover.begin != 0 && passed > 0 &&
                        (timeout <= 0 || static_cast<double>(passed) <= timeout * 1e9));
  }
}

void PairMotions::forgetObjects() {
  for (auto last = stamps_.begin(); last != stamps_.end();) {
    const auto& [link, object] = last->first;
    last = link == 0 && object.expired() ? stamps_.erase(last) : std::next(last);
  }
}

/// Of a pair, the motion is looked at that begins where the one of the older stamps was.
void PairMotions::findWays(WayBound& ways) {
  std::int64_t earliest = 0;  // begin of a motion of this step; 0: none
  for (const MovedBody& mover : movers_) {
    if (mover.was_there && mover.begin < mover.end && (earliest == 0 || mover.begin < earliest))
      earliest = mover.begin;
  }
  for (MovedBody& mover : movers_) {
    const std::int64_t begin = std::min(earliest, mover.begin);
    if (mover.was_there && begin != 0 && begin < mover.end)
      mover.way = ways.of(mover.frame, mover.radius, {begin, mover.end});
  }
}

MovedBody PairMotions::moverOf(const Moment::Body& body, const TransformBuffer& tf) const {
  MovedBody mover;
  const Model& model = *moment_->model;
  if (body.link) {
    mover.frame = tf.find(model.frames[*body.link]).value_or(0);
    mover.radius = radiusOf(model.links[*body.link]);
    return mover;
  }
  mover.radius = radiusOf(body.object->bounded);
  if (body.object->follows()) {
    mover.frame = tf.find(body.object->frame).value_or(0);
    return mover;
  }
  mover.frame = tf.find(model.fixed_frame).value_or(0);
  mover.offset = &body.frame_from_body;
  mover.radius = mover.offset->translation().norm() + mover.offset->linear().norm() * mover.radius;
  return mover;
}

void PairMotions::lookAt(const BoxPair& pair, const LiveBodies& bodies, const TransformBuffer& tf,
                         const Handlers& handlers) {
  MovedBody& first = movers_[pair.first];
  MovedBody& second = movers_[pair.second];
  if (!first.was_there || !second.was_there) return;
  const MotionSpan span{olderStamp(first.begin, second.begin), olderStamp(first.end, second.end)};
  if (span.begin == 0 || span.begin >= span.end) return;
  const std::optional<double> wanted = handlers.wanted(pair.first, pair.second);
  if (!wanted) return;
  auto& [pass, lease] = leases_[{moment_->name(moment_->bodies[pair.first]),
                                 moment_->name(moment_->bodies[pair.second])}];
  const bool is_known = pass + 1 == pass_ && lease.stamp == span.begin;
  const double before = is_known ? lease.distance : -kInfinite;
  pass = pass_;
  WayBound& ways = ways_.try_emplace(first.frame, *edges_, first.frame).first->second;
  const double way = ways.of(second.frame, second.radius, span);
  PairMotion motion{pair.first, pair.second, before - way, {}, 0, 0, ""};
  if (motion.clearance > *wanted) {
    lease = {span.end, motion.clearance};
    handlers.on_motion(motion);
    return;
  }
  first.body = &bodies.body(pair.first);
  second.body = &bodies.body(pair.second);
  const std::optional<Tf2Pose> pose = tf.pose(first.frame, second.frame, span.end);
  std::optional<BodyDistance> now;
  if (pose)
    now = measure(first, Eigen::Affine3d::Identity(), second, MatrixPose(*pose).affine,
                  *wanted + std::max(10 * way, 0.1));
  lease = {span.end, now ? now->lower : -kInfinite};
  motion.clearance = std::max(lease.distance - way, (before + lease.distance - way) / 2);
  if (motion.clearance > *wanted) {
    handlers.on_motion(motion);
    return;
  }
  walk(first, second, span, *wanted, tf, handlers, motion);
  handlers.on_motion(motion);
}

/// The points of the nearest pose are wanted in the fixed frame.
void PairMotions::walk(const MovedBody& first, const MovedBody& second, MotionSpan span,
                       double wanted, const TransformBuffer& tf, const Handlers& handlers,
                       PairMotion& motion) const {
  const Parameters& parameters = moment_->model->parameters;
  MotionPath path = pathBetween(tf, first.frame, second.frame, span, parameters.timeout);
  motion.clearance = 0;
  motion.undecided = path.problem;
  if (!path.problem.empty()) return;
  PairMotionSearch search(first, second, wanted, parameters.distance_limit);
  MotionWalk<PairMotionSearch> walk(path, span, second.radius, search, handlers.gives_up);
  if (!walk.walk()) {
    motion.undecided = walk.wasGivenUp() ? "it was interrupted" : "a pose is not finite";
    return;
  }
  motion.clearance = search.clearance();
  if (search.isUndecided()) motion.undecided = "they came nearer than can be decided";
  motion.stamp = search.stamp();
  motion.duration = span.end - motion.stamp;
  const Frame fixed = *tf.find(moment_->model->fixed_frame);
  const auto first_pose = tf.pose(fixed, first.frame, motion.stamp);
  const auto second_pose = tf.pose(fixed, second.frame, motion.stamp);
  if (first_pose && second_pose)
    motion.nearest = measure(first, MatrixPose(*first_pose).affine, second,
                             MatrixPose(*second_pose).affine, kInfinite);
}

}  // namespace link_bounds
