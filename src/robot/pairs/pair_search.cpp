// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// First poses that collide are looked for: random ones, then downhill from the nearest of these.
// Then boxes of joint values are halved, that with the smallest bound first.
#include "robot/pairs/pair_search.h"

#include <algorithm>
#include <cmath>

#include "robot/pairs/swept_search.h"

namespace link_bounds {
namespace {

/// The pairs of the Panda and of the UR5e are decided alike with 30 to 3,000 samples and 1 to 30
/// descents. Ten times as many samples take 2 to 2.6 times as many instructions, ten times as many
/// descents 2.9 times. Few find less in robots with more joints.
constexpr int kSamples = 300;
constexpr std::size_t kDescents = 3;
constexpr int kDescentSteps = 3000;

/// Between two pairs that are worked on in turn.
constexpr int kSamplesPerSlice = 30;
constexpr int kBranchesPerSlice = 30;

/// A pair that takes as many slices of branching is also searched with fewer joints, and that gets
/// all but one of so many further slices.
constexpr std::size_t kSlicesBeforeSweep = 20;
constexpr std::size_t kSweepShare = 4;

/// With other values of the joint that was left out.
constexpr int kHintedPoses = 30;

/// Of a search for a proof that every pose collides, or that every pose touches.
constexpr int kMaxOpenSteps = 20000;

/// A proof that every pose touches is given up after so many if it would take more than all.
constexpr int kTrialSteps = 500;

/// Further boxes are searched in depth, which needs little memory.
constexpr std::size_t kMaxNodes = 20000;
constexpr std::size_t kMaxNodeBytes = 16'000'000;

/// Of a search without nodes and samples: the memories of two BodyDistances and the rest.
constexpr std::size_t kBytes = 50'000;

/// A pose that is nearer by so much is the start of another descent.
constexpr double kNews = 0.95;

/// Of the range of a joint.
constexpr double kFirstStep = 0.1;
constexpr double kLastStep = 1e-9;

/// A pose that is farther than the tolerance by less is measured [m].
constexpr double kFinest = 1e-3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t bytesOf(const PathValues& values) {
  return sizeof(values) + values.size() * sizeof(double) + 16;  // 16: of malloc()
}

}  // namespace

PairSearch::PairSearch(JointPath path, const PairBody& first, const PairBody& second,
                       const PairGoal& goal, bool may_sweep)
    : path_(std::move(path)),
      goal_(goal),
      motion_(path_, first.hull.cloud, second.hull.cloud),
      first_(&first),
      second_(&second),
      may_sweep_(may_sweep) {
  for (BodyDistances* distances : {&distances_, &hulls_}) {
    const bool is_hull = distances == &hulls_;
    distances->set(0, is_hull ? first.hull.body : first.body);
    distances->set(1, is_hull ? second.hull.body : second.body);
    distances->move(0, Eigen::Affine3d::Identity());
  }
  JointBox all = wholeBox(path_);
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
  return kBytes + path_.joints.size() * 2 * sizeof(PathJoint) +
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
  return samples_ >= kSamples || path_.variables.empty();
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

/// False if its turn has not come, or it ends nothing.
bool PairSearch::sweep() {
  ++branch_slices_;
  if (!may_sweep_ || branch_slices_ < kSlicesBeforeSweep || branch_slices_ % kSweepShare == 0)
    return false;
  if (!swept_)
    swept_ = std::make_unique<SweptSearch>(path_, *first_, *second_, goal_, nearest_.upper);
  if (swept_->isDone()) return false;
  swept_->advance();
  swept_clearance_ = std::max(swept_clearance_, swept_->clearance());
  follow(swept_->takeHint());
  if (clearance() >= enough()) finish();
  return true;
}

/// Downhill from there, with the other variables where they bring the bodies nearest to each other.
void PairSearch::follow(const std::map<std::size_t, double>& hint) {
  if (hint.empty()) return;
  KnownPose best;
  for (int i = 0; i <= kHintedPoses; ++i) {
    PathValues values;
    for (std::size_t v = 0; v < path_.variables.size(); ++v) {
      const Limits& range = path_.ranges[v];
      const auto hinted = hint.find(path_.variables[v]);
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
  distances_ = BodyDistances();
  hulls_ = BodyDistances();
  swept_ = nullptr;
}

/// To a few digits, where these collide, too.
void PairSearch::shortenPose() {
  for (double steps = 100; collides() && steps < 1e7; steps *= 100) {
    PathValues values;
    for (std::size_t v = 0; v < path_.variables.size(); ++v) {
      const Limits& range = path_.ranges[v];
      const double rounded = std::round(nearest_.values[v] * steps) / steps;
      values.push_back(std::min(std::max(rounded, range.lower), range.upper));
    }
    const KnownPose pose = measured(values);
    if (!isTouch(pose.upper)) continue;
    nearest_ = pose;
    return;
  }
}

/// Collisions are common at the ends of ranges.
void PairSearch::sample() {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double limit = starts_.size() < kDescents ? kInfinity : starts_.front().upper;
  for (int i = 0; i < kSamplesPerSlice; ++i, ++samples_) {
    PathValues values;
    for (const Limits& range : path_.ranges) {
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
  path_.place(values, placed_);
  distances_.move(1, Eigen::Affine3d(placed_.first_from_second));
  const double near = std::max(goal_.clearance, goal_.touching) + kFinest;
  const double far = std::min(limit, goal_.clearance + 10);
  distances_.setGoal({PairGoal::kPoseAccuracy, std::max(near, far), PairGoal::kMaxTreeSteps});
  const std::optional<BodyDistance> distance = distances_.find(0, 1);
  if (!distance) return {values};
  return {values, std::max(0.0, distance->lower - motion_.rounding()),
          distance->upper + motion_.rounding()};
}

void PairSearch::offer(const KnownPose& pose) {
  ++poses_;
  was_free_ = was_free_ || pose.lower > goal_.clearance;
  was_apart_ = was_apart_ || pose.lower > std::max(goal_.clearance, goal_.touching);
  if (pose.upper < nearest_.upper) nearest_ = pose;
}

/// Steps along one variable or, in the valleys of the distance, along any direction; smaller ones
/// where none of these leads downhill. After a step that led downhill comes the same way once more,
/// with half of the ways before it: so a descent follows a valley.
void PairSearch::descend(KnownPose pose) {
  const std::size_t count = path_.variables.size();
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

/// The first ways are both along each variable, further ones are random.
PathValues PairSearch::way(double step, std::size_t direction) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::size_t count = path_.variables.size();
  PathValues result;
  for (std::size_t v = 0; v < count; ++v) {
    double share = direction % count == v ? (direction < count ? 1 : -1) : 0;
    if (direction >= 2 * count) share = uniform(random_);
    result.push_back(share * step * width(path_.ranges[v]));
  }
  return result;
}

/// Within the ranges.
PathValues PairSearch::moved(PathValues values, const PathValues& way) const {
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Limits& range = path_.ranges[v];
    values[v] = std::min(std::max(values[v] + way[v], range.lower), range.upper);
  }
  return values;
}

/// A box with that bound needs no more halving.
double PairSearch::enough() const {
  return std::max(nearest_.upper - goal_.accuracy, goal_.clearance + PairGoal::kProof);
}

void PairSearch::branch() {
  for (int i = 0; i < kBranchesPerSlice; ++i) {
    if (collides()) return;
    if (latest_.empty() && (nodes_.empty() || nodes_.top().lower >= enough())) return finish();
    Node node = take();
    node.lower = std::max({node.lower, bound(node.box), swept_clearance_});
    if (node.lower >= enough() || path_.variables.empty()) {
      dropped_ = std::min(dropped_, node.lower);
    } else {
      addHalves(std::move(node));
    }
  }
}

/// Of the box that bound() was last asked about.
void PairSearch::addHalves(Node node) {
  for (JointBox& half : halves(node.box, motion_.widestVariable()))
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

void PairSearch::enter(const JointBox& box) {
  path_.place(box.center, placed_);
  motion_.set(box, placed_);
}

/// Cheap bounds first.
double PairSearch::bound(const JointBox& box) {
  enter(box);
  const double motion = motion_.motion() + motion_.rounding();
  const BodyCloud& first = first_->hull.cloud;
  const BodyCloud& second = second_->hull.cloud;
  const Eigen::Vector3d between = placed_.first_from_second * second.center() - first.center();
  double lower = between.norm() - first.radius() - second.radius() - motion;
  if (lower >= enough()) return lower;
  const Eigen::Affine3d first_from_second(placed_.first_from_second);
  const DistanceGoal goal{std::max(PairGoal::kPoseAccuracy, PairGoal::kShareOfMotion * motion),
                          enough() + motion, PairGoal::kMaxTreeSteps};
  hulls_.move(1, first_from_second);
  hulls_.setGoal(goal);
  const std::optional<BodyDistance> hulls = hulls_.find(0, 1);
  if (!hulls) return 0;
  lower = std::max(lower, hulls->lower - motion);
  if (lower < enough() && hulls->lower > 0)
    lower = std::max(lower, motion_.gapAlong(hulls->normal, first, second) - motion_.rounding());
  if (lower < enough()) lower = std::max(lower, boundOfParts(goal));
  if (lower >= enough()) return lower;
  distances_.move(1, first_from_second);
  distances_.setGoal(goal);
  const std::optional<BodyDistance> distance = distances_.find(0, 1);
  if (!distance) return lower;
  const double nearest_before = nearest_.upper;
  offer({box.center, distance->lower - motion_.rounding(), distance->upper + motion_.rounding()});
  if (nearest_.upper < kNews * nearest_before) starts_ = {nearest_};
  return std::max(lower, distance->lower - motion);
}

/// Between hulls that overlap, those of single shapes may be apart.
double PairSearch::boundOfParts(const DistanceGoal& goal) {
  if (first_->parts.empty() && second_->parts.empty()) return 0;
  const Eigen::Affine3d first_from_second(placed_.first_from_second);
  double lower = kInfinity;
  for (const PairHull* first : partsOf(*first_)) {
    for (const PairHull* second : partsOf(*second_)) {
      const std::optional<BodyDistance> distance = bodyDistance(
          *first->body, Eigen::Affine3d::Identity(), *second->body, first_from_second, goal);
      if (!distance || !(distance->lower > 0)) return 0;
      double of_pair = distance->lower - motion_.motion();
      if (of_pair < enough())
        of_pair =
            std::max(of_pair, motion_.gapAlong(distance->normal, first->cloud, second->cloud));
      lower = std::min(lower, of_pair - motion_.rounding());
      if (!(lower > 0)) return 0;
    }
  }
  return lower;
}

/// Every pose that was tried is near enough, and more is not yet proven or given up.
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
      closed_ += shareOf(box, path_);
      continue;
    }
    if (path_.variables.empty()) return endContact(false);
    for (JointBox& half : halves(box, motion_.widestVariable()))
      open_.push_back(std::move(half));
  }
}

/// Whether to give up the proof that all poses collide, or touch: a pose was found that does not,
/// nothing can prove it, or it takes too many small boxes.
bool PairSearch::isHopeless() const {
  if (open_steps_ > kMaxOpenSteps) return true;
  if (aim_ == Contact::kTouching)
    return was_apart_ || (open_steps_ > kTrialSteps && open_steps_ > closed_ * kMaxOpenSteps);
  const bool has_core = !first_->cores.empty() || !second_->cores.empty();
  return was_free_ || !(has_core || goal_.clearance > 0 || path_.variables.empty());
}

void PairSearch::beginContact() {
  open_ = {wholeBox(path_)};
  open_steps_ = 0;
  closed_ = 0;
}

/// The next aim is weaker.
void PairSearch::endContact(bool is_proven) {
  if (is_proven) contact_ = aim_;
  const bool is_last = is_proven || aim_ == Contact::kTouching;
  aim_ = is_last ? Contact::kNone : Contact::kTouching;
  beginContact();
}

/// Proven: the two stay within the reach, or a point of one body stays in the skin around the core
/// of the other one.
bool PairSearch::isContactIn(const JointBox& box) {
  enter(box);
  const double motion = motion_.motion() + motion_.rounding();
  const KnownPose pose = measured(box.center);
  offer(pose);
  const bool is_always = aim_ == Contact::kColliding;
  if (is_always && path_.variables.empty()) return isTouch(pose.upper);
  const double reach = is_always ? goal_.clearance : std::max(goal_.clearance, goal_.touching);
  if (pose.upper + motion <= reach) return true;
  const Eigen::Affine3d first_from_second(placed_.first_from_second);
  return coreContact(*first_, *second_, first_from_second, reach - motion).has_value();
}

}  // namespace link_bounds
