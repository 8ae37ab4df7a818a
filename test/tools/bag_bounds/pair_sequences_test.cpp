// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random recordings: what comes near between two messages is seen. The truth are dense samples of
// all that the histories of two bodies know.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

#include "testing/body_history.h"
#include "testing/random_carriers.h"
#include "testing/recorded_testing.h"
#include "testing/sanitized.h"
#include "tools/bag_bounds/scene/recorded_scene.h"
#include "tools/bag_bounds/watch/pair_motions.h"

namespace link_bounds {
namespace {

constexpr double kPairLimit = 0.05;   // m
constexpr double kPairTimeout = 0.5;  // s
constexpr double kRounding = 1e-9;    // m
constexpr int kMotionSamples = 16;

/// A ball beside the origin of its frame.
BoundedLink ballLink(const std::string& name, const Eigen::Vector3d& centre, double diameter) {
  Shape shape;
  shape.points =
      std::make_shared<const PointSet>(std::vector<Eigen::Vector3f>{centre.cast<float>()});
  shape.solid = Solid::kEllipsoid;
  shape.size = Eigen::Vector3d::Constant(diameter);
  return {name, {shape}, 0, ""};
}

/// A scene, and what PairMotions says in its last step.
class PairScene {
 public:
  struct Counts {
    int steps = 0, pairs = 0, calls = 0, walks = 0, undecided = 0, dips = 0, rest_dips = 0,
        gone_dips = 0, looks = 0;
  };

  PairScene(const std::string& fixed_frame, const std::vector<BoundedLink>& links,
            double timeout = kPairTimeout) {
    auto model = std::make_shared<Model>(*modelOf(fixed_frame, links));
    model->parameters.timeout = timeout;
    model->parameters.distance_limit = kPairLimit;
    model->attached = {{"object/0", 0}};
    scene_.adopt(model, 1'000'000'000);
    handlers_.wanted = [](const Moment&, const BoxPair&) { return kPairLimit; };
    handlers_.on_motion = [this](const Moment& moment, const PairMotion& motion) {
      ++counts_.calls;
      counts_.walks += motion.nearest.has_value();
      counts_.undecided += !motion.undecided.empty();
      const BodyKey first(moment.bodies[motion.first]), second(moment.bodies[motion.second]);
      PairMotion& call = calls_.try_emplace({is_rest_, first, second}, motion).first->second;
      if (motion.clearance < call.clearance) call = motion;
      if (is_rest_) onRest(moment, motion);
    };
    handlers_.on_forgotten = [this](const std::string&, const std::string&) {
      ++counts_.undecided;
    };
    handlers_.gives_up = [this] {
      ++counts_.looks;
      return false;
    };
  }
  PairScene(const PairScene&) = delete;
  PairScene& operator=(const PairScene&) = delete;
  virtual ~PairScene() = default;

  void take(const CarrierMessage& message) {
    if (scene_.goesBackTo(message.time)) {
      motions_.finish(means());
      last_.reset();
      onJump();
    }
    takeMessage(scene_, message);
  }

  const Counts& counts() const { return counts_; }

  /// The only motion of the last step.
  const PairMotion& motion() const { return calls_.begin()->second; }

 protected:
  /// A link, or an object's content, which may be gone.
  struct BodyKey {
    std::size_t link;
    std::weak_ptr<const ObjectContent> object;

    explicit BodyKey(const Moment::Body& body)
        : link(body.link ? *body.link + 1 : 0), object(body.object) {}
    bool operator<(const BodyKey& other) const {
      return link != other.link ? link < other.link : object.owner_before(other.object);
    }
  };

  using Call = std::tuple<bool, BodyKey, BodyKey>;  // whether one of both is at rest; the bodies

  virtual void onJump() {}
  virtual void onStep() {}
  virtual void onEnd() {}
  virtual void onRest(const Moment&, const PairMotion&) {}

  RecordedScene scene_{[](const std::string&) { return LoadedMesh(); },
                       [this](std::int64_t) { onNews(); }, [](std::int64_t, bool) {}};
  MomentPtr moment_;
  MomentPtr last_;
  std::map<Call, PairMotion> calls_;
  Counts counts_;

 private:
  PairMotions::Means means() { return {pairs_, bodies_, scene_.tf(), handlers_}; }

  void onNews() {
    ++counts_.steps;
    calls_.clear();
    moment_ = momentOf(scene_.scene());
    is_rest_ = true;
    motions_.begin(moment_, scene_.now(), means());
    is_rest_ = false;
    bodies_.update(moment_, {});
    motions_.look(means());
    onStep();
    last_ = moment_;
  }

 public:
  /// The end of the recording, as a step in which no body goes on.
  void end() {
    ++counts_.steps;
    calls_.clear();
    is_rest_ = true;
    motions_.finish(means());
    onEnd();
  }

 private:
  MomentPairs pairs_;
  LiveBodies bodies_{{}};
  PairMotions motions_;
  PairMotions::Handlers handlers_;
  bool is_rest_ = false;
};

class RandomPairs : public PairScene {
 public:
  RandomPairs(std::uint64_t seed, double timeout, double pause)
      : PairScene(seed % 3 == 0 ? "base" : "world", randomLinks(seed), timeout),
        carriers_(seed, pause, seed % 7 < 4 ? 0.6 : 2) {
    if (seed % 5 == 0) receiveTogether(30);
  }

  void receive() { take(carriers_.next()); }

 private:
  /// Until it was deleted or replaced, it is at rest, but moved until its stamp.
  struct GoneObject {
    BodyKey key;
    std::string name;
    Moment::Body seen;
    std::int64_t stamp;
    std::int64_t until;
  };

  /// So that the first message of some frames has several transforms.
  void receiveTogether(int messages) {
    CarrierMessage all;
    for (int i = 0; i < messages; ++i) {
      const CarrierMessage message = carriers_.next();
      if (message.transforms.empty() || message.is_static) {
        take(message);
        continue;
      }
      all.time = message.time;
      all.transforms.insert(all.transforms.end(), message.transforms.begin(),
                            message.transforms.end());
    }
    if (!all.transforms.empty()) take(all);
  }

  static std::vector<BoundedLink> randomLinks(std::uint64_t seed) {
    brute_force::Random random(seed);
    std::vector<BoundedLink> links;
    for (int i = 0; i < RandomCarriers::kArms; ++i) {
      const Eigen::Vector3d centre = random.vector(0.3);
      links.push_back(ballLink(RandomCarriers::armName(i), centre, random.uniform(0.1, 0.25)));
    }
    return links;
  }

  void onJump() override {
    bodies_.clear();
    gone_.clear();
    rests_.clear();
  }

  void onEnd() override {
    if (last_) compareRests();
  }

  /// In each moment both stand at the stamps that they have there.
  void onRest(const Moment& moment, const PairMotion& motion) override {
    double& nearest =
        rests_.try_emplace(restOf(moment, motion.first, motion.second), 1).first->second;
    nearest = std::min(nearest, motion.clearance);
  }

  void onStep() override {
    for (const Moment::Body& body : moment_->bodies)
      add(bodies_[BodyKey(body)], body);
    if (last_) {
      compareRests();
      findGone();
    }
    compareMotions();
    for (const GoneObject& gone : gone_)
      compareGone(gone);
    for (const auto& [call, motion] : calls_) {
      const bool is_here = motion.second < moment_->bodies.size();
      if (!std::get<0>(call) && is_here && motion.nearest) compareNearest(motion);
    }
  }

  /// A motion may last for any time. That of a link begins where tf knows it first.
  void add(BodyHistory& history, const Moment::Body& body) {
    const bool is_first = history.entries.empty();
    history.add(*moment_, body, counts_.steps);
    history.timeout = std::numeric_limits<std::int64_t>::max();
    if (!is_first || !body.link || body.stamp == 0) return;
    const TransformBuffer& tf = scene_.tf();
    const auto fixed = tf.find(moment_->model->fixed_frame), frame = tf.find(*history.frame);
    const std::int64_t oldest = std::min(oldestKnown(tf, *fixed, *frame), body.stamp);
    history.entries.insert(history.entries.begin(), {counts_.steps - 1, oldest});
  }

  /// The bodies and the stamp of the older one, which stands.
  using Rest = std::tuple<BodyKey, BodyKey, std::int64_t>;

  static Rest restOf(const Moment& moment, std::size_t i, std::size_t j) {
    const Moment::Body& first = moment.bodies[i];
    const Moment::Body& second = moment.bodies[j];
    return {BodyKey(first), BodyKey(second), std::min(first.stamp, second.stamp)};
  }

  const BodyHistory& historyOf(const Moment& moment, std::size_t i) const {
    return bodies_.at(BodyKey(moment.bodies[i]));
  }

  template <class Visit>
  void forEachPair(const Moment& moment, Visit visit) {
    for (std::size_t i = 0; i < moment.bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < moment.bodies.size(); ++j) {
        if (isPair(*moment.model, moment.member(i), moment.member(j))) visit(i, j);
      }
    }
  }

  void compareMotions() {
    forEachPair(*moment_, [this](std::size_t i, std::size_t j) {
      ++counts_.pairs;
      compareMotion(historyOf(*moment_, i), historyOf(*moment_, j), i, j);
      compareMotion(historyOf(*moment_, j), historyOf(*moment_, i), i, j);
    });
  }

  /// The motion of one body while the other one is known.
  void compareMotion(const BodyHistory& body, const BodyHistory& other, std::size_t i,
                     std::size_t j) {
    const auto span = body.motionBeside(other, counts_.steps);
    if (!span) return;
    forEachSample(*span, [&](std::int64_t stamp) {
      if (!other.isKnownAt(stamp, counts_.steps)) return;
      counts_.dips += isSeen(*moment_, i, j, distanceAt(*moment_, i, j, stamp, nullptr));
    });
  }

  /// Where a body of the last moment does not go on, the older one of a pair stands until the stamp
  /// of the newer one.
  void compareRests() {
    const int step = counts_.steps;
    forEachPair(*last_, [this, step](std::size_t i, std::size_t j) {
      const BodyHistory& a = historyOf(*last_, i);
      const BodyHistory& b = historyOf(*last_, j);
      if (a.goesOnIn(step) && b.goesOnIn(step)) return;
      const std::size_t a_last = a.entryBefore(step), b_last = b.entryBefore(step);
      const std::int64_t a_end = a.entries[a_last].stamp, b_end = b.entries[b_last].stamp;
      if (a_end == 0 || b_end == 0) return;
      const std::int64_t begin =
          std::max({std::min(a_end, b_end), a.since(a_last), b.since(b_last)});
      forEachSample({begin, std::max(a_end, b_end)}, [&](std::int64_t stamp) {
        const double found =
            distanceAt(*last_, i, j, stamp, a_end < b_end ? &a : &b).value_or(kPairLimit);
        if (found >= kPairLimit) return;
        ++counts_.rest_dips;
        const auto rest = rests_.find(restOf(*last_, i, j));
        EXPECT_TRUE(rest != rests_.end() && rest->second <= found + kRounding)
            << last_->name(last_->bodies[i]) << " and " << last_->name(last_->bodies[j])
            << " came within " << found << " m in a rest, step " << counts_.steps;
      });
    });
  }

  void findGone() {
    for (const Moment::Body& body : last_->bodies) {
      const BodyHistory& history = bodies_.at(BodyKey(body));
      const std::int64_t stamp = history.entries.back().stamp;
      const auto& lost = moment_->incomplete;
      const bool is_lost =
          stamp != 0 && std::count(lost.begin(), lost.end(), last_->name(body)) > 0;
      if (body.object && !is_lost && history.entries.back().step != counts_.steps)
        gone_.push_back({BodyKey(body), last_->name(body), body, stamp, scene_.now()});
    }
  }

  void compareGone(const GoneObject& gone) {
    const BodyHistory& history = bodies_.at(gone.key);
    for (std::size_t i = 0; i < moment_->bodies.size(); ++i) {
      const Moment::Body& body = moment_->bodies[i];
      const auto span = historyOf(*moment_, i).motionIn(counts_.steps);
      const bool is_other = moment_->name(body) != gone.name;
      const PairMember member{&gone.name, std::nullopt};
      if (!span || !is_other || !isPair(*moment_->model, moment_->member(i), member)) continue;
      forEachSample(*span, [&](std::int64_t stamp) {
        if (stamp > std::max(gone.until, gone.stamp)) return;
        const bool moved = stamp < gone.stamp;
        if (moved && !history.isKnownAt(stamp, counts_.steps)) return;
        const auto pose = poseAt(body, historyOf(*moment_, i), stamp);
        const auto gone_pose =
            moved ? poseAt(gone.seen, history, stamp) : std::optional(gone.seen.frame_from_body);
        if (!pose || !gone_pose) return;
        const auto found = distance(historyOf(*moment_, i), *pose, history, *gone_pose);
        counts_.gone_dips += found && *found < kPairLimit;
        EXPECT_TRUE(!found || isSeen({false, BodyKey(body), gone.key}, *found))
            << moment_->name(body) << " came within " << *found << " m of " << gone.name
            << ", which is gone, step " << counts_.steps;
      });
    }
  }

  /// Without the begin, at which a moment was looked at.
  template <class Visit>
  static void forEachSample(MotionSpan span, Visit visit) {
    for (int k = 1; k <= kMotionSamples && span.begin < span.end; ++k)
      visit(span.begin + (span.end - span.begin) * k / kMotionSamples);
  }

  /// Nothing is found where it is not.
  void compareNearest(const PairMotion& motion) const {
    const auto truth = distanceAt(*moment_, motion.first, motion.second, motion.stamp, nullptr);
    const double found = motion.nearest->lower;
    EXPECT_TRUE(truth ? std::abs(found - *truth) < kPairAccuracy / 4 : found > kPairLimit)
        << found << " m, step " << counts_.steps;
  }

  /// As tf2 interpolates. `standing` stays where it is in the moment. Nothing if it is far above
  /// the limit, or if tf has forgotten where they were.
  std::optional<double> distanceAt(const Moment& moment, std::size_t i, std::size_t j,
                                   std::int64_t stamp, const BodyHistory* standing) const {
    const BodyHistory& a = historyOf(moment, i);
    const BodyHistory& b = historyOf(moment, j);
    const auto pose = [&](std::size_t k, const BodyHistory& body) {
      return &body == standing ? std::optional(moment.bodies[k].frame_from_body)
                               : poseAt(moment.bodies[k], body, stamp);
    };
    const auto a_pose = pose(i, a), b_pose = pose(j, b);
    if (!a_pose || !b_pose) return std::nullopt;
    return distance(a, *a_pose, b, *b_pose);
  }

  static std::optional<double> distance(const BodyHistory& a, const Eigen::Affine3d& a_pose,
                                        const BodyHistory& b, const Eigen::Affine3d& b_pose) {
    const double apart = (a_pose.translation() - b_pose.translation()).norm();
    if (apart > a.radius + b.radius + 2 * kPairLimit) return std::nullopt;
    return bodyDistance(a.body, a_pose, b.body, b_pose, {1e-5})->upper;
  }

  std::optional<Eigen::Affine3d> poseAt(const Moment::Body& seen, const BodyHistory& body,
                                        std::int64_t stamp) const {
    if (!body.frame || body.isStatic()) return seen.frame_from_body;
    const TransformBuffer& tf = scene_.tf();
    const auto fixed = tf.find(moment_->model->fixed_frame), frame = tf.find(*body.frame);
    const auto pose = tf.pose(*fixed, *frame, stamp);
    EXPECT_TRUE(pose || scene_.scene().model()->parameters.timeout == 0) << "tf knew it before";
    return pose ? std::optional(MatrixPose(*pose).affine) : std::nullopt;
  }

  /// True if the distance is below the limit. Then there must have been a call.
  bool isSeen(const Moment& moment, std::size_t i, std::size_t j,
              const std::optional<double>& distance) const {
    if (!distance) return false;
    const Moment::Body& first = moment.bodies[i];
    const Moment::Body& second = moment.bodies[j];
    const bool is_seen =
        isSeen({&moment == last_.get(), BodyKey(first), BodyKey(second)}, *distance);
    EXPECT_TRUE(is_seen) << moment.name(first) << " and " << moment.name(second) << " came within "
                         << *distance << " m, step " << counts_.steps;
    return *distance < kPairLimit;
  }

  bool isSeen(const Call& expected, double distance) const {
    const auto call = calls_.find(expected);
    return call == calls_.end() ? distance >= kPairLimit
                                : call->second.clearance <= distance + kRounding;
  }

  RandomCarriers carriers_;
  std::map<BodyKey, BodyHistory> bodies_;
  std::vector<GoneObject> gone_;
  std::map<Rest, double> rests_;  ///< the smallest proven distance of all looks at them [m]
};

PairScene::Counts countRandomPairs(int recordings, double timeout, double pause) {
  PairScene::Counts sum;
  for (int seed = 1; seed <= recordings && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomPairs recording(static_cast<std::uint64_t>(seed), timeout, pause);
    for (int i = 0; i < 150; ++i)
      recording.receive();
    recording.end();
    const PairScene::Counts& counts = recording.counts();
    sum.pairs += counts.pairs;
    sum.calls += counts.calls;
    sum.walks += counts.walks;
    sum.undecided += counts.undecided;
    sum.dips += counts.dips;
    sum.rest_dips += counts.rest_dips;
    sum.gone_dips += counts.gone_dips;
  }
  std::cout << sum.pairs << " pairs, " << sum.calls << " calls, " << sum.walks << " walks, "
            << sum.undecided << " undecided, " << sum.dips << ", " << sum.rest_dips << " and "
            << sum.gone_dips << " samples below the limit\n";
  return sum;
}

TEST(PairSequences, WhatComesNearBetweenMessagesIsSeen) {
  constexpr int kRecordings = repetitions(400);
  const PairScene::Counts sum = countRandomPairs(kRecordings, kPairTimeout, kPairTimeout);
  EXPECT_GT(sum.dips, 100 * kRecordings);
  EXPECT_GT(sum.rest_dips, 5 * kRecordings);
  EXPECT_GT(sum.gone_dips, kRecordings);
  EXPECT_LT(sum.calls, sum.pairs / 2);
  EXPECT_LT(sum.undecided, sum.calls / 20);
}

/// Nothing is ever stale, and pauses are longer than what is looked at as one rest, or than what tf
/// remembers.
TEST(PairSequences, WhatComesNearDuringLongPausesIsSeen) {
  constexpr int kRecordings = repetitions(200);
  const PairScene::Counts sum = countRandomPairs(kRecordings, 0, 4);
  EXPECT_GT(sum.dips, 50 * kRecordings);
  EXPECT_GT(sum.rest_dips, 5 * kRecordings);
  EXPECT_GT(sum.gone_dips, kRecordings);
}

/// A ball stands, another one is at that place in the message of that number.
class TwoBalls : public PairScene {
 public:
  TwoBalls() : PairScene("world", {ball("still"), ball("moving")}) {}

  void send(int number, const Eigen::Vector3d& place) {
    const double stamp = 1 + 0.01 * number;
    const auto none = Eigen::Quaterniond::Identity();
    CarrierMessage message;
    message.time = std::llround(stamp * 1e9);
    message.transforms = {edge("world", "still", stamp, none, Eigen::Vector3d::Zero()),
                          edge("world", "moving", stamp, none, place)};
    take(message);
  }

  /// A ball at rest, at that height, after the newest message.
  void sendPost(double height) {
    CarrierMessage message;
    message.time = scene_.now() + 1;
    message.marker.header.frame_id = "world";
    message.marker.ns = "post";
    message.marker.type = visualization_msgs::Marker::SPHERE;
    message.marker.pose.position.z = height;
    message.marker.pose.orientation.w = 1;
    message.marker.scale.x = message.marker.scale.y = message.marker.scale.z = 0.1;
    take(message);
  }

 private:
  static BoundedLink ball(const std::string& name) {
    return ballLink(name, Eigen::Vector3d::Zero(), 0.2);
  }
};

/// Only their boxes are within the limit.
TEST(PairSequences, ALeaseLastsUntilTheBodiesHaveMovedSoFar) {
  constexpr int kMotions = 400;
  TwoBalls scene;
  double before = 0;
  int renewals = 0;
  for (int i = 0; i <= kMotions; ++i) {
    scene.send(i, Eigen::Vector3d::Constant(i % 2 == 0 ? 0.225 : 0.2251));
    ASSERT_EQ(scene.counts().calls, i);
    if (i == 0) continue;
    const double clearance = scene.motion().clearance;
    EXPECT_GT(clearance, kPairLimit);
    EXPECT_LT(clearance, std::sqrt(3) * 0.2251 - 0.2);
    renewals += clearance >= before;
    before = clearance;
  }
  std::cout << renewals << " new distances in " << kMotions << " motions\n";
  EXPECT_EQ(scene.counts().walks, 0);
  EXPECT_LT(renewals, kMotions / 20);
}

TEST(PairSequences, WhatIsFarAwayIsNotLookedAt) {
  TwoBalls scene;
  for (int i = 0; i < 100; ++i)
    scene.send(i, {i % 2 == 0 ? 1 : 1.1, 0, 0});
  EXPECT_EQ(scene.counts().steps, 100);
  EXPECT_EQ(scene.counts().calls, 0);
}

TEST(PairSequences, AStepWithoutAnyMotionLooksAtNoPair) {
  TwoBalls scene;
  for (int i = 0; i < 100; ++i)
    scene.send(i, Eigen::Vector3d::Constant(i % 2 == 0 ? 0.225 : 0.2251));
  scene.sendPost(5);
  const int looks = scene.counts().looks;
  for (int i = 0; i < 9; ++i)
    scene.sendPost(6 + i);
  EXPECT_EQ(scene.counts().steps, 110);
  EXPECT_EQ(scene.counts().looks, looks);
}

}  // namespace
}  // namespace link_bounds
