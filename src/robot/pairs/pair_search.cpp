// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// First looks for poses that collide: random ones, then downhill from the nearest of these. Then
// halves boxes of joint values, the one with the smallest bound first.
#include "robot/pairs/pair_search.h"

#include <algorithm>
#include <cmath>

#include "robot/pairs/swept_search.h"

namespace link_bounds {
namespace {

/// The pairs of the Panda and of the UR5e are decided alike with 30 to 3,000 samples and 1 to 30
/// descents. Ten times as many samples take 2 to 2.6 times as many instructions, ten times as many
/// descents 2.9 times. Fewer would find less in robots with more joints.
constexpr int kSamples = 300;
constexpr std::size_t kDescents = 3;
constexpr int kDescentSteps = 3000;

/// The work of one slice, after which another pair may have its turn.
constexpr int kSamplesPerSlice = 30;
constexpr int kBranchesPerSlice = 30;

/// A pair that has taken this many slices of branching is also searched with fewer joints, which
/// gets all but one of kSweepShare further slices.
constexpr std::size_t kSlicesBeforeSweep = 20;
constexpr std::size_t kSweepShare = 4;

/// Poses that are tried for a hint of SweptSearch, with other values of the joints that it leaves
/// out.
constexpr int kHintedPoses = 30;

/// Max steps of a search for a proof that every pose collides, or that every pose touches.
constexpr int kMaxOpenSteps = 20000;

/// A proof that every pose touches is given up after so many steps if, at this rate, it would take
/// more than kMaxOpenSteps.
constexpr int kTrialSteps = 500;

/// Max boxes in the queue; further ones are searched depth first, which needs little memory.
constexpr std::size_t kMaxNodes = 20000;
constexpr std::size_t kMaxNodeBytes = 16'000'000;

/// Memory of a search without nodes and samples: two BodyDistances and the rest.
constexpr std::size_t kBytes = 50'000;

/// A pose whose distance is below this share of the smallest one so far starts another descent.
constexpr double kNews = 0.95;

/// First and last step of a descent, as shares of the range of a joint.
constexpr double kFirstStep = 0.1;
constexpr double kLastStep = 1e-9;

/// A distance is measured, whatever the limit, if it exceeds the tolerance by less than this [m].
constexpr double kFinest = 1e-3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t bytesOf(const PathValues& values) {
  return sizeof(values) + values.size() * sizeof(double) + 16;  // 16: of malloc()
}

}  // namespace

PairSearch::PairSearch(JointPath path, const PairBody& first, const PairBody& second,
                       const PairGoal& goal, bool may_sweep)
    : pair_(std::move(path), first, second), goal_(goal), may_sweep_(may_sweep) {
  pair_.begin();
  JointBox all = wholeBox(pair_.path());
  max_nodes_ = std::min(kMaxNodes, kMaxNodeBytes / (sizeof(Node) + 2 * bytesOf(all.center)));
  offer(measured(all.center));
  if (nearest_.upper == kInfinity) is_done_ = true;
  add({0, std::move(all)});
  beginContact();
}

PairSearch::~PairSearch() = default;

std::size_t PairSearch::bytes() const {
  const std::size_t pose = bytesOf(nearest_.values);
  const std::size_t boxes = nodes_.size() + latest_.size() + open_.size();
  return kBytes + path().joints.size() * 2 * sizeof(PathJoint) +
         starts_.size() * (sizeof(KnownPose) + pose) + boxes * (sizeof(Node) + 2 * pose) +
         (swept_ ? swept_->bytes() : 0);
}

bool PairSearch::isTouch(double distance) const {
  return distance <= goal_.clearance + PairGoal::kTouch;
}

bool PairSearch::collides() const {
  return isTouch(nearest_.upper);
}

bool PairSearch::isFree() const {
  return clearance() > goal_.clearance;
}

double PairSearch::clearance() const {
  double result = std::min(dropped_, nodes_.empty() ? kInfinity : nodes_.top().lower);
  for (const Node& node : latest_)
    result = std::min(result, node.lower);
  return std::max(result, swept_clearance_);
}

bool PairSearch::isSampled() const {
  return samples_ >= kSamples || path().variables.empty();
}

void PairSearch::advance() {
  ++slices_;
  if (collides() && was_apart_) return finish();
  if (!isSampled()) return sample();
  if (mayTouch()) return proveContact();
  if (collides()) return finish();
  if (!starts_.empty()) {
    const KnownPose start = starts_.back();
    starts_.pop_back();
    return descend(start);
  }
  if (!sweep()) branch();
}

/// Advances the search with fewer joints. False if this slice is not its turn, or if it is done.
bool PairSearch::sweep() {
  ++branch_slices_;
  if (!may_sweep_ || branch_slices_ < kSlicesBeforeSweep || branch_slices_ % kSweepShare == 0)
    return false;
  if (!swept_)
    swept_ =
        std::make_unique<SweptSearch>(path(), pair_.first(), pair_.second(), goal_, nearest_.upper);
  if (swept_->isDone()) return false;
  swept_->advance();
  swept_clearance_ = std::max(swept_clearance_, swept_->clearance());
  follow(swept_->takeHint());
  if (clearance() >= enough()) finish();
  return true;
}

/// Starts a descent at the hinted values, with the other variables where they bring the bodies
/// nearest to each other.
void PairSearch::follow(const std::map<std::size_t, double>& hint) {
  if (hint.empty()) return;
  KnownPose best;
  for (int i = 0; i <= kHintedPoses; ++i) {
    PathValues values;
    for (std::size_t v = 0; v < path().variables.size(); ++v) {
      const Limits& range = path().ranges[v];
      const auto hinted = hint.find(path().variables[v]);
      values.push_back(hinted != hint.end()
                           ? hinted->second
                           : std::min(range.lower + width(range) * i / kHintedPoses, range.upper));
    }
    const KnownPose pose = measured(values);
    if (pose.upper < best.upper) best = pose;
  }
  if (!best.values.empty()) starts_.push_back(best);
}

void PairSearch::finish() {
  dropped_ = clearance();
  shortenPose();
  is_done_ = true;
  nodes_ = {};
  latest_ = {};
  pair_.end();
  swept_ = nullptr;
}

/// Rounds the nearest pose to a few digits if the rounded one collides, too.
void PairSearch::shortenPose() {
  for (double steps = 100; collides() && steps < 1e7; steps *= 100) {
    PathValues values;
    for (std::size_t v = 0; v < path().variables.size(); ++v) {
      const Limits& range = path().ranges[v];
      const double rounded = std::round(nearest_.values[v] * steps) / steps;
      values.push_back(std::min(std::max(rounded, range.lower), range.upper));
    }
    const KnownPose pose = measured(values);
    if (!isTouch(pose.upper)) continue;
    nearest_ = pose;
    return;
  }
}

/// Tries random poses, with many values at the ends of ranges, where collisions are common.
void PairSearch::sample() {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double limit = starts_.size() < kDescents ? kInfinity : starts_.front().upper;
  for (int i = 0; i < kSamplesPerSlice; ++i, ++samples_) {
    PathValues values;
    for (const Limits& range : path().ranges) {
      const double share = std::min(std::max(1.2 * uniform(random_) - 0.1, 0.0), 1.0);
      values.push_back(std::min(range.lower + share * width(range), range.upper));
    }
    const KnownPose pose = measured(values, limit);
    offer(pose);
    starts_.push_back(pose);
    if (collides() && was_apart_) return;
  }
  const auto isNearer = [](const KnownPose& a, const KnownPose& b) { return a.upper > b.upper; };
  std::sort(starts_.begin(), starts_.end(), isNearer);
  if (starts_.size() > kDescents) starts_.erase(starts_.begin(), starts_.end() - kDescents);
}

KnownPose PairSearch::measured(const PathValues& values, double limit) {
  pair_.place(values);
  const double near = std::max(goal_.clearance, goal_.touching) + kFinest;
  const double far = std::min(limit, goal_.clearance + 10);
  const std::optional<BodyDistance> distance =
      pair_.distance({PairGoal::kPoseAccuracy, std::max(near, far), PairGoal::kMaxTreeSteps});
  if (!distance) return {values};
  return {values, std::max(0.0, distance->lower - pair_.rounding()),
          distance->upper + pair_.rounding()};
}

void PairSearch::offer(const KnownPose& pose) {
  ++poses_;
  was_free_ = was_free_ || pose.lower > goal_.clearance;
  was_apart_ = was_apart_ || pose.lower > std::max(goal_.clearance, goal_.touching);
  if (pose.upper < nearest_.upper) nearest_ = pose;
}

/// Takes steps along one variable or, in a valley of the distance, along any direction, and halves
/// them when none leads downhill. After a step that led downhill, it first repeats that step plus
/// half of the trend before it, so that a descent follows a valley.
void PairSearch::descend(KnownPose pose) {
  const std::size_t count = path().variables.size();
  const PathValues none(count, 0.0);
  PathValues trend = none;
  int left = kDescentSteps;
  for (double step = kFirstStep; step > kLastStep && left > 0 && !isTouch(pose.upper);) {
    bool is_lower = false;
    for (std::size_t i = 0; i <= 4 * count && !is_lower; ++i, --left) {
      const KnownPose other =
          measured(moved(pose.values, i == 0 ? trend : way(step, i - 1)), pose.upper);
      is_lower = other.upper < pose.upper;
      if (!is_lower) {
        if (i == 0) trend = none;
        continue;
      }
      for (std::size_t v = 0; v < count; ++v)
        trend[v] = trend[v] / 2 + other.values[v] - pose.values[v];
      pose = other;
    }
    if (!is_lower) step /= 2;
  }
  offer(pose);
}

/// The first steps go both ways along each variable; further ones have random directions.
PathValues PairSearch::way(double step, std::size_t direction) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::size_t count = path().variables.size();
  PathValues result;
  for (std::size_t v = 0; v < count; ++v) {
    double share = direction % count == v ? (direction < count ? 1 : -1) : 0;
    if (direction >= 2 * count) share = uniform(random_);
    result.push_back(share * step * width(path().ranges[v]));
  }
  return result;
}

/// The values after a step, clamped to the ranges.
PathValues PairSearch::moved(PathValues values, const PathValues& way) const {
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Limits& range = path().ranges[v];
    values[v] = std::min(std::max(values[v] + way[v], range.lower), range.upper);
  }
  return values;
}

/// A box whose bound is at least this is not halved further [m].
double PairSearch::enough() const {
  return std::max(nearest_.upper - goal_.accuracy, goal_.clearance + PairGoal::kProof);
}

void PairSearch::branch() {
  for (int i = 0; i < kBranchesPerSlice; ++i) {
    if (collides()) return;
    if (latest_.empty() && (nodes_.empty() || nodes_.top().lower >= enough())) return finish();
    Node node = take();
    node.lower = std::max({node.lower, bound(node.box), swept_clearance_});
    if (node.lower >= enough() || path().variables.empty()) {
      dropped_ = std::min(dropped_, node.lower);
    } else {
      addHalves(std::move(node));
    }
  }
}

/// The box of `node` must be the one that bound() was last called for.
void PairSearch::addHalves(Node node) {
  for (JointBox& half : halves(node.box, pair_.widestVariable()))
    add({node.lower, std::move(half)});
}

void PairSearch::add(Node node) {
  if (nodes_.size() < max_nodes_) {
    nodes_.push(std::move(node));
  } else {
    latest_.push_back(std::move(node));
  }
}

PairSearch::Node PairSearch::take() {
  if (latest_.empty()) {
    Node node = nodes_.top();
    nodes_.pop();
    return node;
  }
  Node node = std::move(latest_.back());
  latest_.pop_back();
  return node;
}

/// A lower bound of the distance in the box [m]; cheap bounds are tried first.
double PairSearch::bound(const JointBox& box) {
  pair_.enter(box);
  const double motion = pair_.motion();
  double lower = pair_.ballGap() - motion;
  if (lower >= enough()) return lower;
  const DistanceGoal goal = pair_.goalFor(enough());
  const std::optional<double> hulls = pair_.hullBound(goal, enough());
  if (!hulls) return 0;
  lower = std::max(lower, *hulls);
  if (lower < enough()) lower = std::max(lower, pair_.partsBound(goal, enough()));
  if (lower >= enough()) return lower;
  const std::optional<BodyDistance> distance = pair_.distance(goal);
  if (!distance) return lower;
  const double nearest_before = nearest_.upper;
  offer({box.center, distance->lower - pair_.rounding(), distance->upper + pair_.rounding()});
  if (nearest_.upper < kNews * nearest_before) starts_ = {nearest_};
  return std::max(lower, distance->lower - motion);
}

/// True if every pose that was tried touches, and the proof for all poses is neither complete nor
/// given up.
bool PairSearch::mayTouch() const {
  return !was_apart_ && aim_ != Contact::kNone;
}

/// Boxes of joint values are halved until the bodies are in contact in each whole box.
void PairSearch::proveContact() {
  for (int i = 0; i < kBranchesPerSlice; ++i, ++open_steps_) {
    if (open_.empty()) return endContact(true);
    if (isHopeless()) return endContact(false);
    const JointBox box = std::move(open_.back());
    open_.pop_back();
    if (isContactIn(box)) {
      closed_ += shareOf(box, path());
      continue;
    }
    if (path().variables.empty()) return endContact(false);
    for (JointBox& half : halves(box, pair_.widestVariable()))
      open_.push_back(std::move(half));
  }
}

/// Whether to give up the proof that all poses collide, or touch: a pose was found that does not,
/// nothing can prove it, or it takes too many small boxes.
bool PairSearch::isHopeless() const {
  if (open_steps_ > kMaxOpenSteps) return true;
  if (aim_ == Contact::kTouching)
    return was_apart_ || (open_steps_ > kTrialSteps && open_steps_ > closed_ * kMaxOpenSteps);
  const bool has_core = !pair_.first().cores.empty() || !pair_.second().cores.empty();
  return was_free_ || !(has_core || goal_.clearance > 0 || path().variables.empty());
}

void PairSearch::beginContact() {
  open_ = {wholeBox(path())};
  open_steps_ = 0;
  closed_ = 0;
}

/// Ends the proof of the current aim. The next aim is weaker.
void PairSearch::endContact(bool is_proven) {
  if (is_proven) contact_ = aim_;
  const bool is_last = is_proven || aim_ == Contact::kTouching;
  aim_ = is_last ? Contact::kNone : Contact::kTouching;
  beginContact();
}

/// True if it is proven that the two stay within `max_distance` in the box, or that a point of one
/// body stays in the skin around the core of the other one.
bool PairSearch::isContactIn(const JointBox& box) {
  pair_.enter(box);
  const double motion = pair_.motion();
  const KnownPose pose = measured(box.center);
  offer(pose);
  const bool is_always = aim_ == Contact::kColliding;
  if (is_always && path().variables.empty()) return isTouch(pose.upper);
  const double max_distance =
      is_always ? goal_.clearance : std::max(goal_.clearance, goal_.touching);
  if (pose.upper + motion <= max_distance) return true;
  return coreContact(pair_.first(), pair_.second(), pair_.pose(), max_distance - motion)
      .has_value();
}

}  // namespace link_bounds
