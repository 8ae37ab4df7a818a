// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A pair is examined as a motion of the second body in the frame of the first one.
#include "tools/bag_bounds/watch/pair_motions.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "world/history/swept_box.h"

namespace link_bounds {
namespace {

constexpr std::uint64_t kNoPass = std::numeric_limits<std::uint64_t>::max();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Max number of gone objects that are examined: those of some seconds, if many change often.
constexpr std::size_t kMaxGone = 10'000;

/// The first stamp at which tf knows the pose of the link [ns]. Its box may come later, for example
/// if a message has several transforms of one frame.
std::int64_t firstStampOf(const Model& model, std::size_t link, const TransformBuffer& tf) {
  const auto fixed = tf.find(model.fixed_frame), frame = tf.find(model.frames[link]);
  return fixed && frame ? oldestKnown(tf, *fixed, *frame) : 0;
}

void stand(MovedBody& body, TransformBuffer::Frame frame, const Eigen::Affine3d& pose) {
  body.frame = frame;
  body.offset = &pose;
  body.radius = pose.translation().norm() + pose.linear().norm() * body.radius;
}

/// After a rest of this length, motions beside the body at rest are examined, before tf forgets
/// them [ns].
constexpr std::int64_t kLongestRest = EdgeHistory::kLength / 2;

/// Up to which stamps the movers of a moment were compared with bodies at rest [ns].
struct RestTimes {
  std::int64_t newest = 0;  ///< newest stamp of all movers
  std::int64_t end = 0;     ///< up to here, moving bodies were examined beside those at rest

  explicit RestTimes(const std::vector<MovedBody>& movers) {
    for (const MovedBody& mover : movers)
      newest = std::max(newest, mover.end);
    for (const MovedBody& mover : movers) {
      if (newest - mover.end < kLongestRest) end = olderStamp(end, mover.end);
    }
  }

  bool isLong(const MovedBody& body) const {
    return newest - std::max({body.end, body.since, body.rested}) >= kLongestRest;
  }
};

}  // namespace

void PairMotions::remember(const Scene& scene, std::int64_t now) {
  if (moment_) return;
  scene.forEach([&](const SceneBody& body) {
    const std::int64_t stamp = body.state.stamp;
    if (!body.state.box || stamp == 0) return;
    const auto& object = scene.boxSource(body).object;
    if (object && !object->follows()) return;
    const auto [known, is_new] = known_.try_emplace(BodyKey(body.link, object));
    const Known before = known->second;
    const bool goes_on = !is_new && stamp >= before.stamp;
    known->second = {stamp, goes_on ? before.since : stamp, kNoPass, 0, true, stamp};
    compareClocks(stamp, now);
  });
  forgetObjects();
}

/// Finds the objects of the last moment that are gone. Earlier ones stay while they are needed. An
/// object that was replaced stands until the stamp of the new one, which may be ahead of the
/// recorder.
void PairMotions::findGone(const Moment& moment, std::int64_t now, const Means& means) {
  const std::size_t count = moment_ ? moment_->bodies.size() - needed_gone_ : 0;
  const std::size_t known_gone = gone_.size();
  std::set<const ObjectContent*> present;
  std::map<std::string, std::int64_t> stamps;
  for (std::size_t i = 0; i < count; ++i) {
    const Moment::Body& body = moment_->bodies[i];
    if (!body.object) continue;
    if (i < moment.bodies.size() && moment.bodies[i].object == body.object) continue;
    if (present.empty()) {
      for (const Moment::Body& other : moment.bodies) {
        present.insert(other.object.get());
        if (other.object && !other.object->follows()) stamps[moment.name(other)] = other.stamp;
      }
    }
    if (present.count(body.object.get()) != 0) continue;
    const auto& lost = moment.incomplete;
    const std::string& name = moment_->name(body);
    if (movers_[i].end != 0 && std::find(lost.begin(), lost.end(), name) != lost.end()) continue;
    addGone(i, std::max(stampAt(now), stamps[name]), means);
  }
  if (gone_.size() > known_gone) forgetGone();
}

void PairMotions::addGone(std::size_t i, std::int64_t until, const Means& means) {
  const Moment::Body& body = moment_->bodies[i];
  const MovedBody& mover = movers_[i];
  const auto measured = means.bodies.sharedBody(i);
  const bool moves = mover.end != 0;
  gone_.push_back({body, measured, moves ? mover.since : 0, moves ? mover.end : until, false});
  if (moves && mover.end < until) gone_.push_back({body, measured, mover.end, until, true});
}

void PairMotions::compareClocks(std::int64_t stamp, std::int64_t now) {
  delay_ = std::min(delay_.value_or(MovedBody::kForEver), now - stamp);
}

/// Converts a record time to the clock of stamps. If both clocks are the same, no delay is negative
/// and the min is small. Otherwise the min delay counts as the difference of the clocks, although
/// it includes the latency of that transform, which is not known.
std::int64_t PairMotions::stampAt(std::int64_t recorded) const {
  const std::int64_t delay = delay_.value_or(0);
  return delay < 0 || delay > kLongestRest ? recorded - delay : recorded;
}

/// No motion that is not known yet begins before this stamp. A link that never had a box may still
/// come with all that tf knows of it, and its stamps may lag behind those of others.
std::int64_t PairMotions::oldestNeeded(std::int64_t newest) const {
  std::int64_t oldest = MovedBody::kForEver;
  std::size_t links = 0;
  for (const auto& [key, known] : known_) {
    links += key.link != 0;
    if (known.moves) oldest = std::min(oldest, known.stamp);
  }
  const auto has_shapes = [](const BoundedLink& link) { return !link.shapes.empty(); };
  const auto& all = moment_->model->links;
  const auto expected = std::count_if(all.begin(), all.end(), has_shapes);
  const bool lacks_link = links < static_cast<std::size_t>(expected);
  return lacks_link ? std::min(oldest, newest - 2 * EdgeHistory::kLength) : oldest;
}

/// Forgets gone objects once the stamps of all moving bodies have passed their end. A body without
/// new stamps may move on later, because tf may only have stalled. So objects that are dropped
/// earlier, because they are too old or too many, are remembered by name until then.
void PairMotions::forgetGone() {
  std::int64_t newest = 0;
  for (const auto& [key, known] : known_)
    if (known.moves) newest = std::max(newest, known.stamp);
  const std::int64_t oldest = oldestNeeded(newest);
  const auto is_over = [oldest](const Gone& gone) { return gone.until <= oldest; };
  gone_.erase(std::remove_if(gone_.begin(), gone_.end(), is_over), gone_.end());
  if (forgotten_until_ <= oldest) forgotten_.clear();
  std::size_t excess = gone_.size() - std::min(gone_.size(), kMaxGone);
  std::vector<Gone> kept;
  for (Gone& gone : gone_) {
    if (newest - gone.until <= EdgeHistory::kLength && excess == 0) {
      kept.push_back(std::move(gone));
      continue;
    }
    if (excess > 0) --excess;
    std::int64_t& until = forgotten_[gone.seen.object->bounded.name];
    until = std::max(until, gone.until);
    forgotten_until_ = std::max(forgotten_until_, until);
  }
  gone_ = std::move(kept);
}

/// The moment, plus the gone objects that were there when a motion began that ends now.
MomentPtr PairMotions::withGone(const MomentPtr& moment, const TransformBuffer& tf) {
  needed_gone_ = 0;
  if (gone_.empty()) return moment;
  std::int64_t earliest = MovedBody::kForEver;
  for (const Moment::Body& body : moment->bodies) {
    const auto known = known_.find(BodyKey(body));
    const bool was_known = known != known_.end() && known->second.stamp != 0;
    if (was_known && known->second.moves && known->second.stamp != body.stamp)
      earliest = std::min(earliest, known->second.stamp);
    if (!was_known && body.link && body.stamp != 0)
      earliest = std::min(earliest, firstStampOf(*moment->model, *body.link, tf));
  }
  const auto others = std::partition(gone_.begin(), gone_.end(),
                                     [=](const Gone& gone) { return earliest < gone.until; });
  needed_gone_ = static_cast<std::size_t>(others - gone_.begin());
  if (needed_gone_ == 0) return moment;
  auto all = std::make_shared<Moment>(*moment);
  for (auto gone = gone_.begin(); gone != others; ++gone)
    all->bodies.push_back(gone->seen);
  return all;
}

void PairMotions::begin(const MomentPtr& present, std::int64_t now, const Means& means) {
  ++pass_;
  for (const Moment::Body& body : present->bodies) {
    const bool moves = body.stamp != 0 && (!body.object || body.object->follows());
    if (moves) compareClocks(body.stamp, now);
  }
  findGone(*present, now, means);
  const MomentPtr moment = withGone(present, means.tf);
  last_ = std::exchange(moment_, moment);
  std::vector<MovedBody> before = std::exchange(movers_, {});
  for (const Moment::Body& body : present->bodies) {
    MovedBody mover = moverOf(body, means.tf);
    mover.end = !body.object || body.object->follows() ? body.stamp : 0;
    mover.since = mover.end;
    movers_.push_back(mover);
  }
  findBegins(*present, means.tf, before);
  for (std::size_t i = 0; i < needed_gone_; ++i)
    movers_.push_back(moverOf(gone_[i], moment->bodies[present->bodies.size() + i], means.tf));
  forgetObjects();
  if (!edges_) edges_.emplace(means.tf);
  const auto fixed = means.tf.find(moment->model->fixed_frame);
  if (fixed) findWays(means.tf, *fixed);
  if (last_) lookAtRests(before, means);
}

void PairMotions::look(const Means& means) {
  double way = 0;
  for (const MovedBody& mover : movers_)
    way = std::max(way, mover.way);
  if (way > 0) {
    for (const BoxPair& pair : near(moment_, 2 * way, means)) {
      if (means.handlers.gives_up()) break;
      lookAt(pair, means);
    }
    lookAtForgotten(means);
  }
  for (auto lease = leases_.begin(); lease != leases_.end();)
    lease = lease->second.first == pass_ ? std::next(lease) : leases_.erase(lease);
}

void PairMotions::finish(const Means& means) {
  last_ = moment_;
  if (last_) lookAtRests(std::exchange(movers_, {}), means);
  moment_.reset();
  gone_.clear();
  forgotten_.clear();
  forgotten_until_ = 0;
  needed_gone_ = 0;
  known_.clear();
  delay_.reset();
}

/// Pairs of the moment within the limit plus `way` [m]: before they moved so far, they may have
/// been within the limit.
std::vector<BoxPair> PairMotions::near(const MomentPtr& moment, double way, const Means& means) {
  std::vector<BoxPair> near;
  const double margin = moment->model->parameters.distance_limit + way;
  means.pairs.read(
      moment, std::min(margin, std::numeric_limits<double>::max()),
      [&near](const NearPairs& found) { near = found.compared; }, means.handlers.gives_up);
  return near;
}

/// Remembers the stamps of this moment for the next ones, and sets which movers of the last moment
/// go on; a body that does not move always does. The motion of a body that goes on was not yet
/// examined beside bodies that rest since its stamp.
void PairMotions::findBegins(const Moment& moment, const TransformBuffer& tf,
                             std::vector<MovedBody>& last_movers) {
  const RestTimes rests(last_movers);
  std::int64_t earliest = 0;  // begin of a motion that ends now
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Moment::Body& body = moment.bodies[i];
    MovedBody& mover = movers_[i];
    const auto [known, is_new] = known_.try_emplace(BodyKey(body));
    Known before =
        std::exchange(known->second, {body.stamp, mover.since, pass_, i, mover.end != 0});
    if (is_new && body.object && !body.object->follows()) {
      mover.was_there = true;
      mover.is_placed_now = last_ != nullptr;
      mover.since = body.stamp;  // not later: it may have been there before
    }
    const bool is_first = body.link && mover.end != 0 && before.stamp == 0;
    if (is_first)
      before.stamp = before.since =
          std::min(firstStampOf(*moment.model, *body.link, tf), mover.end);
    if (is_new && !is_first) continue;
    mover.begin = mover.end == 0 ? 0 : before.stamp;
    const std::int64_t passed = mover.end - mover.begin;
    mover.was_there = passed >= 0;
    if (!mover.was_there) continue;
    mover.since = known->second.since = before.since;
    mover.reported = known->second.reported = before.reported;
    if (passed > 0) earliest = olderStamp(earliest, mover.begin);
    if (is_new || before.pass + 1 != pass_) continue;
    MovedBody& last = last_movers[before.place];
    last.goes_on = last.end == 0 || !rests.isLong(last);
    if (passed == 0) mover.rested = last.goes_on ? last.rested : rests.end;
  }
  for (MovedBody& mover : movers_)
    if (earliest != 0) mover.rested = std::min(mover.rested, earliest);
}

void PairMotions::forgetObjects() {
  for (auto last = known_.begin(); last != known_.end();) {
    const BodyKey& key = last->first;
    last = key.link == 0 && key.object.expired() ? known_.erase(last) : std::next(last);
  }
}

/// Sets the way of each mover. The motion of a pair is examined from the older of its two stamps
/// on, with an object that is placed now as far back as tf remembers.
void PairMotions::findWays(const TransformBuffer& tf, Frame fixed) {
  WayBound& ways = ways_.try_emplace(fixed, *edges_, fixed).first->second;
  std::int64_t moved = MovedBody::kForEver;   // begin of a motion that ends now
  std::int64_t placed = MovedBody::kForEver;  // first stamp of what is placed now
  for (const MovedBody& mover : movers_) {
    if (mover.is_placed_now) placed = std::min(placed, mover.since);
    if (mover.was_there && mover.begin != 0 && mover.begin < mover.end)
      moved = std::min(moved, mover.begin);
  }
  if (std::min(moved, placed) == MovedBody::kForEver) return;
  for (MovedBody& mover : movers_) {
    const std::int64_t end = std::max(mover.end, mover.moved_until);
    if (!mover.was_there || end == 0) continue;
    std::int64_t begin = olderStamp(moved, mover.begin);
    if (placed < begin)
      begin = std::min(begin, std::max(placed, oldestKnown(tf, fixed, mover.frame)));
    begin = std::max(begin, mover.since);
    if (begin < end) mover.way = ways.of(mover.frame, mover.radius, {begin, end});
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
  stand(mover, tf.find(model.fixed_frame).value_or(0), body.frame_from_body);
  return mover;
}

/// `body` is the entry of the gone object in the moment.
MovedBody PairMotions::moverOf(const Gone& gone, const Moment::Body& body,
                               const TransformBuffer& tf) const {
  MovedBody mover = moverOf(body, tf);
  if (gone.rests)
    stand(mover, tf.find(moment_->model->fixed_frame).value_or(0), body.frame_from_body);
  mover.body = gone.body.get();
  mover.was_there = true;
  mover.since = gone.since;
  mover.until = gone.until;
  mover.moved_until = gone.since != 0 && !gone.rests ? gone.until : 0;
  return mover;
}

/// Examines a pair from the time on at which both are known. An object may have been placed with an
/// older stamp than tf still knows.
void PairMotions::lookAt(const BoxPair& pair, const Means& means) {
  MovedBody& first = movers_[pair.first];
  MovedBody& second = movers_[pair.second];
  if (!first.was_there || !second.was_there) return;
  const bool is_placed_now = first.is_placed_now || second.is_placed_now;
  const std::int64_t begin = is_placed_now
                                 ? std::max({oldestKnown(means.tf, first.frame, second.frame),
                                             first.reported, second.reported})
                                 : olderStamp(first.begin, second.begin);
  const MotionSpan span{std::max({begin, first.since, second.since}),
                        std::min({olderStamp(first.end, second.end), first.until, second.until})};
  // A rest may begin with the last pose that is known.
  const bool is_pose = second.isGone() && first.begin < span.end && span.begin == span.end;
  if (span.begin == 0 || (span.begin >= span.end && !is_pose)) return;
  const bool is_same_name =
      moment_->name(moment_->bodies[pair.first]) == moment_->name(moment_->bodies[pair.second]);
  if (is_same_name && second.isGone()) return;
  const std::optional<double> wanted = means.handlers.wanted(*moment_, pair);
  if (!wanted) return;
  auto& [pass, lease] =
      leases_[{BodyKey(moment_->bodies[pair.first]), BodyKey(moment_->bodies[pair.second])}];
  if (pass + 1 != pass_ || lease.stamp != span.begin) lease = {};
  pass = pass_;
  lookDuring(span, *moment_, pair, first, second, *wanted, lease, means);
}

/// Their places are not known, so it is undecided whether movers came near them.
void PairMotions::lookAtForgotten(const Means& means) const {
  if (forgotten_.empty()) return;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const MovedBody& mover = movers_[i];
    const bool has_moved = mover.was_there && mover.way > 0 && mover.begin < mover.end;
    if (!has_moved || mover.begin >= forgotten_until_) continue;
    const PairMember member = moment_->member(i);
    for (const auto& [name, until] : forgotten_) {
      const bool is_other = mover.begin < until && name != *member.name;
      if (is_other && isPair(*moment_->model, member, {&name, std::nullopt}))
        means.handlers.on_forgotten(*member.name, name);
    }
  }
}

/// `movers` are those of the last moment.
void PairMotions::lookAtRests(const std::vector<MovedBody>& movers, const Means& means) {
  std::int64_t oldest = 0;
  for (const MovedBody& mover : movers)
    oldest = olderStamp(oldest, std::max(mover.end, mover.rested));
  std::int64_t begin = 0;  // no examined motion begins earlier
  for (const MovedBody& mover : movers) {
    if (mover.end != 0 && !mover.goes_on)
      begin = olderStamp(begin, std::max({mover.since, mover.reported, oldest}));
  }
  if (begin == 0) return;
  const Frame fixed = *means.tf.find(last_->model->fixed_frame);
  WayBound& ways = ways_.try_emplace(fixed, *edges_, fixed).first->second;
  double way = 0;
  for (const MovedBody& mover : movers) {
    const std::int64_t from = std::max(begin, mover.since);
    if (mover.end > from)
      way = std::max(way, ways.of(mover.frame, mover.radius, {from, mover.end}));
  }
  if (way == 0) return;
  for (const BoxPair& pair : near(last_, way, means)) {
    if (means.handlers.gives_up()) break;
    lookAtRest(pair, movers[pair.first], movers[pair.second], means);
  }
}

/// For a pair of the last moment: examines how the body of the newer stamp moved beside the other
/// one.
void PairMotions::lookAtRest(const BoxPair& pair, MovedBody first, MovedBody second,
                             const Means& means) {
  if ((first.goes_on && second.goes_on) || first.end == 0 || second.end == 0) return;
  const bool is_first_older = first.end < second.end;
  const MovedBody& older = is_first_older ? first : second;
  const MotionSpan span{std::max({older.end, older.rested, first.since, second.since,
                                  first.reported, second.reported}),
                        std::max(first.end, second.end)};
  if (span.begin >= span.end) return;
  const std::optional<double> wanted = means.handlers.wanted(*last_, pair);
  if (!wanted) return;
  stand(is_first_older ? first : second, *means.tf.find(last_->model->fixed_frame),
        last_->bodies[is_first_older ? pair.first : pair.second].frame_from_body);
  Lease lease;
  lookDuring(span, *last_, pair, first, second, *wanted, lease, means);
}

/// Examines a pair during `span`, and renews its lease, which must end where the span begins.
void PairMotions::lookDuring(MotionSpan span, const Moment& moment, const BoxPair& pair,
                             MovedBody& first, MovedBody& second, double wanted, Lease& lease,
                             const Means& means) {
  WayBound& ways = ways_.try_emplace(first.frame, *edges_, first.frame).first->second;
  const double way = ways.of(second.frame, second.radius, span);
  const double before = lease.distance;
  PairMotion motion{pair.first, pair.second, before - way, {}, 0, 0, ""};
  if (motion.clearance > wanted) {
    lease = {span.end, motion.clearance};
    means.handlers.on_motion(moment, motion);
    return;
  }
  if (!first.isGone()) first.body = &means.bodies.body(pair.first);
  if (!second.isGone()) second.body = &means.bodies.body(pair.second);
  const std::optional<Tf2Pose> pose = means.tf.pose(first.frame, second.frame, span.end);
  std::optional<BodyDistance> now;
  if (pose)
    now = distanceOf(first, Eigen::Affine3d::Identity(), second, MatrixPose(*pose).affine,
                     wanted + std::max(10 * way, 0.1));
  lease = {span.end, now ? now->lower : -kInfinite};
  motion.clearance = std::max(lease.distance - way, (before + lease.distance - way) / 2);
  if (motion.clearance <= wanted) walk(first, second, span, wanted, means, motion);
  means.handlers.on_motion(moment, motion);
}

/// Searches the motion itself. The points of the nearest pose are needed in the fixed frame.
void PairMotions::walk(const MovedBody& first, const MovedBody& second, MotionSpan span,
                       double wanted, const Means& means, PairMotion& motion) const {
  const TransformBuffer& tf = means.tf;
  const Parameters& parameters = moment_->model->parameters;
  const PairFinding found = searchPair(tf, first, second, span, wanted, parameters.distance_limit,
                                       means.handlers.gives_up);
  motion.clearance = found.clearance;
  motion.undecided = found.undecided;
  if (!found.nearest_stamp) return;
  motion.stamp = *found.nearest_stamp;
  motion.duration = span.end - motion.stamp;
  const Frame fixed = *tf.find(moment_->model->fixed_frame);
  const auto first_pose = tf.pose(fixed, first.frame, motion.stamp);
  const auto second_pose = tf.pose(fixed, second.frame, motion.stamp);
  if (first_pose && second_pose)
    motion.nearest = distanceOf(first, MatrixPose(*first_pose).affine, second,
                                MatrixPose(*second_pose).affine, kInfinite);
}

}  // namespace link_bounds
