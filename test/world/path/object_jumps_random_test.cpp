// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects through jumps of the clock, late transforms and changes of the fixed frame, in random
// order. After each step, what must hold is read off the list of all that was sent and of where
// everything was then, without the states that objects have.
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <iostream>

#include "testing/live_boxes_testing.h"
#include "testing/marker_testing.h"
#include "testing/sanitized.h"
#include "world/bodies/scene_feed.h"
#include "world/history/scene_copy.h"
#include "world/path/path_scene.h"
#include "world/stopping/body_ways.h"

namespace link_bounds {
namespace {

using visualization_msgs::Marker;
using Nanoseconds = std::int64_t;

constexpr int kJumpRuns = 150;
constexpr int kJumpSteps = 400;  // of a run
constexpr int kJumpingObjects = 4;
constexpr Nanoseconds kTenth = 100'000'000;
constexpr Nanoseconds kStepTime = kTenth;
constexpr Nanoseconds kTolerated = 5 * kTenth;  // a stamp is ahead of the clock by no more
constexpr Nanoseconds kTicks = 2 * kStepTime;   // what is seen with a tick
constexpr Nanoseconds kFresh = 5 * kTenth;      // tf, for tf to be surely there
constexpr double kSamePlace = 1e-6;             // m

/// The arm turns without end; the base stands.
constexpr char kJumpingArm[] = R"(<robot name="arm">
  <link name="base"><visual><geometry><box size="0.2 0.2 0.2"/></geometry></visual></link>
  <link name="arm"><visual><geometry><box size="0.7 0.1 0.1"/></geometry></visual></link>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/>
    <axis xyz="0 0 1"/><limit effort="1" velocity="1"/></joint>
</robot>)";

/// A time of the world: how often the clock had jumped back, and what it showed.
struct EraTime {
  int era = 0;
  Nanoseconds stamp = 0;
};

/// Each era has other places. tf interpolates between two samples without an error.
Eigen::Isometry3d mapFrom(const std::string& frame, const EraTime& at) {
  const double era = at.era;
  const double seconds = static_cast<double>(at.stamp) / 1e9;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (frame == "odom") pose.translation().x() = 0.3;
  if (frame == "base" || frame == "arm") pose.translation().x() = 3 * era;
  if (frame == "arm")
    pose.rotate(Eigen::AngleAxisd(0.3 * era + 0.1 * seconds, Eigen::Vector3d::UnitZ()));
  if (frame == "camera") pose.translation() << 0.7 * era + 0.3 * seconds, 1.1 * era, 0;
  return pose;
}

const std::vector<std::pair<std::string, std::string>> kJumpingEdges = {
    {"map", "odom"}, {"map", "base"}, {"base", "arm"}, {"map", "camera"}};

/// A marker as it was sent. Each other content has another size.
struct SentContent {
  int size = 0;  // of a cube [mm]
  std::string frame;
  Nanoseconds stamp = 0;  // 0: it follows the frame
  bool is_locked = false;
  int era = 0;  // of the sender when it made the marker

  bool follows() const { return stamp == 0 || is_locked; }
};

struct SentMarker {
  int object = 0;
  std::optional<SentContent> content;  // nothing: it is deleted
  std::size_t step = 0;
};

/// After which everything is compared.
struct JumpingStep {
  Nanoseconds now = 0;
  int era = 0;
  Nanoseconds era_start = 0;
  Nanoseconds adopted = 0;
  std::string fixed_frame;
};

struct JumpingEdge {
  Nanoseconds lag = 0;
  int silent = 0;  // for that many steps
  Nanoseconds newest = 0;
  Nanoseconds renewed = 0;  // when the clock said so, with a newer stamp
};

std::shared_ptr<const Model> jumpingModel(const std::string& fixed_frame, double timeout) {
  Parameters parameters;
  parameters.fixed_frame = fixed_frame;
  parameters.timeout = timeout;
  parameters.attached = {{"arm", {"held/*"}}};
  parameters.velocity_window = 0.5;
  parameters.deceleration = {{"turn", 1.0}};
  parameters.base_deceleration = {{"linear", 1.0}, {"angular", 1.0}};
  RobotLoader loader([](const MeshFile&) { return TriangleMesh(); });
  return std::make_shared<const Model>(makeModel(kJumpingArm, parameters, loader, {}));
}

/// How often each kind of thing was seen, so that the test shows that it is not empty.
struct JumpsSeen {
  long placed = 0, of_another_era = 0, incomplete = 0, placed_late = 0, held = 0, not_held = 0,
       stopping = 0, copied_over_a_jump = 0;

  void add(const JumpsSeen& other) {
    placed += other.placed;
    of_another_era += other.of_another_era;
    incomplete += other.incomplete;
    placed_late += other.placed_late;
    held += other.held;
    not_held += other.not_held;
    stopping += other.stopping;
    copied_over_a_jump += other.copied_over_a_jump;
  }
};

class JumpingScene {
 public:
  explicit JumpingScene(std::uint64_t seed)
      : random_(seed), timeout_(seed % 4 == 0 ? 0 : 2), patience_(seed % 4 == 0 ? 10 : 2) {
    now_.fixed_frame = "map";
    adopt();
    SentContent post{5, "map", 0, true, 0};
    send({"post", 0}, post);
  }

  void step() {
    moveClock();
    for (std::size_t i = 0; i < kJumpingEdges.size(); ++i)
      sendTransform(i);
    if (!steps_.empty() && chance(0.3)) sendMarker(pick(kJumpingObjects));
    if (chance(0.03)) {
      now_.fixed_frame = now_.fixed_frame == "map" ? "odom" : "map";
      adopt();
    }
    feed_.onTick(time());
    steps_.push_back(now_);
    for (int object = 0; object < kJumpingObjects; ++object)
      expectRightBox(object);
    expectRightCopies();
  }

  const JumpsSeen& seen() const { return seen_; }

 private:
  // Events:

  bool chance(double probability) { return random_.uniform(0, 1) < probability; }
  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }
  Nanoseconds tenths(double low, double high) {
    return static_cast<Nanoseconds>(random_.uniform(low, high)) * kTenth;
  }
  ros::Time time() const { return ros::Time().fromNSec(static_cast<std::uint64_t>(now_.now)); }
  EraTime present() const { return {now_.era, now_.now}; }

  void moveClock() {
    now_.now += kStepTime;
    steady_ += ros::WallDuration(0.1);
    if (chance(0.01)) now_.now += tenths(5, 100);
    feed_.onTick(time());
    if (!chance(0.015)) return;
    const Nanoseconds back = chance(0.3) ? tenths(2, 6) : tenths(3, 90);
    const Nanoseconds before = now_.now;
    now_.now -= back;
    now_.era_start = now_.now;
    ++now_.era;
    for (JumpingEdge& edge : edges_)
      edge.newest = edge.renewed = 0;
    feed_.onTick(time());
    // What was sent before the jump arrives after it, and its stamp tells so.
    const SentContent late = newContent({now_.era - 1, before});
    const bool tells = late.stamp < now_.now || late.stamp > now_.now + kTolerated;
    if (tells && chance(0.3)) send(pick(kJumpingObjects), late);
  }

  void sendTransform(std::size_t i) {
    JumpingEdge& edge = edges_[i];
    if (chance(0.03)) edge.lag = tenths(0, 12);
    if (chance(0.01)) edge.silent = pick(50);
    if (edge.silent > 0) --edge.silent;
    if (edge.silent > 0 || chance(0.1)) return;
    const EraTime at{now_.era, now_.now - edge.lag};
    const auto& [parent, child] = kJumpingEdges[i];
    const Eigen::Isometry3d pose = mapFrom(parent, at).inverse() * mapFrom(child, at);
    geometry_msgs::TransformStamped message =
        link_bounds::edge(parent, child, 0, Eigen::Quaterniond(pose.linear()), pose.translation());
    message.header.stamp.fromNSec(static_cast<std::uint64_t>(at.stamp));
    if (at.stamp > edge.newest) {
      edge.newest = at.stamp;
      edge.renewed = now_.now;
    }
    feed_.onTransforms(
        {message}, false, [] { return "/sender"; }, time(), steady_);
  }

  SentContent newContent(const EraTime& at) {
    static const char* const kFrames[] = {"map", "odom", "arm", "camera", "camera"};
    SentContent content;
    content.size = ++contents_ + 10;
    content.frame = kFrames[pick(5)];
    content.stamp = chance(0.1) ? 0 : at.stamp + tenths(-10, 4) + 1000 * contents_;
    if (content.stamp != 0 && chance(0.3))
      content.stamp = std::max(latestCommonTime("arm"), kTenth);
    content.is_locked = chance(0.1);
    content.era = at.era;
    return content;
  }

  /// Only who sent a marker before repeats it, or changes all but its stamp.
  void sendMarker(int object) {
    const SentContent* const last = contentOf(object);
    const double kind = random_.uniform(0, 1);
    if (!last || kind < 0.4) return send(object, newContent(present()));
    if (kind < 0.8) return send(object, *last);
    if (kind < 0.9) return send(object, std::nullopt);
    SentContent resized = *last;
    resized.size = ++contents_ + 10;
    send(object, resized);
  }

  void send(int object, const std::optional<SentContent>& content) {
    send(keyOf(object), content);
    sent_.push_back({object, content, steps_.size()});
  }

  void send(const ObjectKey& key, const std::optional<SentContent>& content) {
    Marker marker = markerOf(Marker::CUBE, Eigen::Vector3d::Ones());
    marker.ns = key.ns;
    marker.id = key.id;
    if (content) {
      marker.scale.x = marker.scale.y = marker.scale.z = content->size * 1e-3;
      marker.header.frame_id = content->frame;
      marker.header.stamp.fromNSec(static_cast<std::uint64_t>(content->stamp));
      marker.frame_locked = content->is_locked;
    } else {
      marker.action = Marker::DELETE;
    }
    feed_.onMarkers(&marker, 1, "/sender", time());
  }

  void adopt() {
    model_ = models_[now_.fixed_frame == "map" ? 0 : 1];
    now_.adopted = now_.now;
    feed_.adopt(model_, time());
  }

  // What follows from them:

  /// The first two are attached to the arm.
  static ObjectKey keyOf(int object) { return {object < 2 ? "held" : "free", object}; }

  /// What is there of an object: all that was sent since it was last deleted.
  std::vector<const SentMarker*> since(int object) const {
    std::vector<const SentMarker*> result;
    for (const SentMarker& sent : sent_) {
      if (sent.object != object) continue;
      if (sent.content)
        result.push_back(&sent);
      else
        result.clear();
    }
    return result;
  }

  /// Null if there is none.
  const SentContent* contentOf(int object) const {
    const auto all = since(object);
    return all.empty() ? nullptr : &*all.back()->content;
  }

  const JumpingStep& stepOf(const SentMarker& sent) const {
    return sent.step < steps_.size() ? steps_[sent.step] : now_;
  }

  /// Where the content is if it was placed in that era.
  std::optional<Aabb> boxIn(int era, const SentContent& content, Nanoseconds stamp) const {
    const Eigen::Isometry3d fixed_from_map = mapFrom(now_.fixed_frame, {}).inverse();
    const Eigen::Isometry3d pose = fixed_from_map * mapFrom(content.frame, {era, stamp});
    const Eigen::Vector3d size = Eigen::Vector3d::Constant(content.size * 1e-3);
    const BoundedLink body{"", {{nullptr, Solid::kBox, size, Eigen::Affine3d::Identity()}}, 0, ""};
    return linkBox(body, Eigen::Affine3d(pose));
  }

  static bool isNear(const Aabb& a, const Aabb& b) {
    return (a.min() - b.min()).norm() + (a.max() - b.max()).norm() < kSamePlace;
  }

  bool isInOneOfItsEras(int object, const SentContent& content, const Aabb& box) const {
    for (const SentMarker* sent : since(object)) {
      if (sent->content->size == content.size &&
          isNear(box, *boxIn(stepOf(*sent).era, content, content.stamp)))
        return true;
    }
    return false;
  }

  bool isPlausible(const SentMarker& sent) const {
    const JumpingStep& step = stepOf(sent);
    const Nanoseconds stamp = sent.content->stamp;
    return step.era == now_.era && (now_.era == 0 || stamp >= step.era_start) &&
           stamp <= step.now + kTolerated;
  }

  /// When it was last sent with a stamp that the present era can have had. Nothing: never.
  std::optional<Nanoseconds> sentInThisEra(int object) const {
    std::optional<Nanoseconds> result;
    for (const SentMarker* sent : since(object)) {
      if (sent->content->size != contentOf(object)->size) continue;
      if (isPlausible(*sent)) result = stepOf(*sent).now;
    }
    return result;
  }

  bool isInTf(const std::string& frame, Nanoseconds stamp) {
    TransformBuffer& tf = feed_.tf();
    const auto to = tf.find(now_.fixed_frame);
    const auto from = tf.find(frame);
    return to && from && tf.pose(*to, *from, stamp);
  }

  /// Those between the frame and the fixed frame.
  std::vector<const JumpingEdge*> pathOf(const std::string& frame) const {
    std::vector<const JumpingEdge*> result;
    for (std::size_t i = 0; i < kJumpingEdges.size(); ++i) {
      const std::string& child = kJumpingEdges[i].second;
      const bool is_above = child == frame || (frame == "arm" && child == "base");
      if (is_above != (child == now_.fixed_frame)) result.push_back(&edges_[i]);
    }
    return result;
  }

  /// Whether each transform of the path came a moment ago.
  bool isFresh(const std::string& frame) const {
    const auto path = pathOf(frame);
    return std::all_of(path.begin(), path.end(), [this](const JumpingEdge* edge) {
      return edge->renewed >= now_.now - kFresh;
    });
  }

  /// What was placed in the other fixed frame.
  bool canCarry() const { return isFresh(now_.fixed_frame == "map" ? "odom" : "map"); }

  /// 0 if there is no edge.
  Nanoseconds latestCommonTime(const std::string& frame) const {
    Nanoseconds result = 0;
    for (const JumpingEdge* edge : pathOf(frame))
      result = result == 0 ? edge->newest : std::min(result, edge->newest);
    return result;
  }

  // Comparisons:

  void expectRightBox(int object) {
    const LiveObjects::Objects& objects = feed_.scene().objects.objects();
    const auto found = objects.find(keyOf(object));
    const SentContent* const content = contentOf(object);
    ASSERT_EQ(found != objects.end(), content != nullptr);
    if (!content) return;
    SCOPED_TRACE(found->second.content->bounded.name + ' ' + content->frame);
    const BoxState& state = found->second.state;
    ASSERT_TRUE(state.box || state.incomplete) << "it is missing";
    seen_.incomplete += state.incomplete;
    if (content->follows())
      expectFollower(*content, found->second);
    else
      expectPlaced(object, *content, state);
  }

  void expectFollower(const SentContent& content, const LiveObject& object) {
    const BoxState& state = object.state;
    if (!state.incomplete) {
      const Nanoseconds stamp = state.stamp == 0 ? now_.now : state.stamp;
      ASSERT_TRUE(isNear(*state.box, *boxIn(now_.era, content, stamp)));
    }
    if (isFresh(content.frame) && isInTf(content.frame, latestCommonTime(content.frame))) {
      ASSERT_FALSE(state.incomplete);
    }
  }

  void expectPlaced(int object, const SentContent& content, const BoxState& state) {
    const auto sent = sentInThisEra(object);
    if (!state.incomplete) {
      ASSERT_TRUE(isInOneOfItsEras(object, content, *state.box)) << "no sender said so";
      ++seen_.placed;
      seen_.of_another_era += !sent;
    } else if (state.box) {
      bool is_any = false;
      for (const SentMarker* earlier : since(object))
        is_any = is_any || earlier->content->follows() ||
                 isInOneOfItsEras(object, *earlier->content, *state.box);
      ASSERT_TRUE(is_any) << "no sender said that it ever was there";
    }
    if (!sent && stepOf(*since(object).back()).era < now_.era) {
      ASSERT_LE(state.stamp, now_.era_start);
    }
    const Nanoseconds patience = patience_ * 1'000'000'000;
    if (sent && now_.now <= *sent + patience && canCarry() &&
        isInTf(content.frame, content.stamp)) {
      ASSERT_FALSE(state.incomplete)
          << "tf has it since " << content.stamp
          << feed_.scene().objects.reason(feed_.scene().objects.objects().at(keyOf(object))) << ' '
          << (int)feed_.scene().objects.objects().at(keyOf(object)).stamp_time << ' ' << *sent
          << ' ' << now_.now << now_.fixed_frame << now_.adopted << ' ' << now_.era_start << ' '
          << now_.era << feed_.scene().objects.objects().at(keyOf(object)).placement.has_value();
      ASSERT_TRUE(isNear(*state.box, *boxIn(now_.era, content, content.stamp))) << "tf has it";
      known_.insert(content.size);
      seen_.placed_late += now_.now - *sent > kStepTime;
    }
    const Nanoseconds last_sent = stepOf(*since(object).back()).now;
    const bool has_waited =
        now_.now > std::max({last_sent, now_.adopted, now_.era_start}) + patience + kTicks;
    if (has_waited && known_.count(content.size) > 0 && canCarry()) {
      ASSERT_FALSE(state.incomplete) << "it was placed once";
    }
    if (known_.count(content.size) > 0 && canCarry()) {
      ASSERT_TRUE(state.box) << "where it was placed once";
    }
  }

  struct Copy {
    SceneCopy copy;
    std::shared_ptr<const Model> model;
    bool is_path;
    int era;
    bool is_new;
  };

  /// Some copies take several steps.
  void expectRightCopies() {
    for (const bool is_path : {true, false}) {
      const BoxRequest request = is_path ? pathRequest() : wayRequest(model_->parameters);
      Copy whole{SceneCopy(request, model_), model_, is_path, now_.era, true};
      expectRightCopy(whole);
      if (copies_.size() < 2)
        copies_.push_back({SceneCopy(request, model_), model_, is_path, now_.era, false});
    }
    for (std::size_t i = copies_.size(); i-- > 0;) {
      if (copies_[i].model != model_) {
        copies_.erase(copies_.begin() + static_cast<std::ptrdiff_t>(i));
      } else if (copies_[i].copy.proceed(feed_.scene(), time(), std::chrono::nanoseconds(0)) ||
                 chance(0.1)) {
        seen_.copied_over_a_jump += copies_[i].era != now_.era;
        expectRightCopy(copies_[i]);
        copies_.erase(copies_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }

  void expectRightCopy(Copy& copy) {
    while (!copy.copy.proceed(feed_.scene(), time(), std::chrono::seconds(1))) {
    }
    const std::unique_ptr<PastScene> past = copy.copy.take();
    if (copy.is_path)
      expectRightPath(*past, copy.is_new);
    else
      expectRightStop(*past);
  }

  /// What was sent as this content; also after it was deleted.
  const SentContent* sentAs(const ObjectContent& body) const {
    const int size = static_cast<int>(std::lround(body.bounded.shapes.at(0).size.x() * 1e3));
    for (const SentMarker& sent : sent_) {
      if (sent.content && sent.content->size == size) return &*sent.content;
    }
    return nullptr;
  }

  void expectRightPath(PastScene& past, bool is_new) {
    const auto goes_on = [] { return false; };
    PathTrees trees([](const auto&, const auto&) { return std::vector<LoadedTree>(); });
    trees.prepare(past, goes_on);
    const PathScene path = pathScene(past, {"turn"}, trees, {1000, goes_on});
    ASSERT_EQ(path.bodies.size(), past.bodies.size());
    for (std::size_t i = 0; i < path.bodies.size(); ++i) {
      const PastBody& body = past.bodies[i];
      if (body.link || path.names[i] == "post/0") continue;
      SCOPED_TRACE(path.names[i] + " in the path");
      const bool is_held = path.names[i].compare(0, 4, "held") == 0;
      const SentContent* const content = sentAs(*body.object);
      ASSERT_NE(content, nullptr);
      const bool is_known = path.bodies[i].is_whole;
      if (is_known && is_held) expectPlaceOnArm(*content, path.bodies[i]);
      if (is_held) ++(is_known ? seen_.held : seen_.not_held);
    }
    for (int object = 0; is_new && object < kJumpingObjects; ++object) {
      const auto name = std::find(path.names.begin(), path.names.end(), objectName(keyOf(object)));
      if (name != path.names.end() && mustBeHeld(object)) {
        const auto i = static_cast<std::size_t>(name - path.names.begin());
        ASSERT_TRUE(path.bodies[i].is_whole) << *name << ": " << path.problem;
      }
    }
  }

  /// In the era of its sender.
  void expectPlaceOnArm(const SentContent& content, const PathBody& body) const {
    const EraTime at{content.era, content.stamp};
    const Eigen::Isometry3d arm_from_object =
        mapFrom("arm", at).inverse() * mapFrom(content.frame, at);
    const Eigen::Affine3d& place = body.body.shapes.at(0).shape.link_from_shape;
    if (content.follows()) {
      ASSERT_EQ(content.frame, "arm");
      ASSERT_LT(place.translation().norm(), kSamePlace);
    } else {
      ASSERT_LT((place.translation() - arm_from_object.translation()).norm(), kSamePlace);
    }
  }

  /// An object whose stamp is new in this era, which was placed in this fixed frame, and whose link
  /// tf has at its stamp.
  bool mustBeHeld(int object) {
    const SentContent* const content = contentOf(object);
    if (object >= 2 || !content || content->follows() || known_.count(content->size) == 0)
      return false;
    for (const SentMarker* sent : since(object)) {
      if (sent->content->stamp != content->stamp) continue;
      if (!isPlausible(*sent)) return false;
      for (std::size_t step = sent->step - 1; step < steps_.size(); ++step) {
        if (steps_[step].fixed_frame != now_.fixed_frame) return false;
      }
    }
    const LiveObject& live = feed_.scene().objects.objects().at(keyOf(object));
    return content->era == now_.era && !live.state.incomplete && isFresh("arm") &&
           isInTf("arm", latestCommonTime("arm")) && isInTf("arm", content->stamp);
  }

  void expectRightStop(PastScene& past) {
    const StopRules rules(past.model);
    BodyWays braking(past, rules, WayPurpose::kStandstill, nullptr);
    BodyWays going_on(past, rules, WayPurpose::kContact, nullptr);
    for (const PastBody& body : past.bodies) {
      const std::string& name = body.bounded->name;
      if (name.compare(0, 4, "held") != 0 || !body.frame || body.incomplete) continue;
      const SentContent* const content = sentAs(*body.object);
      ASSERT_NE(content, nullptr);
      if (content->follows()) continue;
      SCOPED_TRACE(name + " in ~stopping and ~earliest");
      for (BodyWays* const ways : {&braking, &going_on}) {
        const BodyWay way = ways->find(body);
        if (!way.problem.empty()) continue;
        ASSERT_EQ(content->era, now_.era) << "where it is on the arm is not known";
        ++seen_.stopping;
      }
    }
  }

  brute_force::Random random_;
  const double timeout_;
  const Nanoseconds patience_;  // s
  const std::shared_ptr<const Model> models_[2] = {jumpingModel("map", timeout_),
                                                   jumpingModel("odom", timeout_)};
  ros::SteadyTime steady_{1000};
  SceneFeed feed_{{[](const MeshRequest&) {}, [] {}}, [this] { return steady_; }};
  std::shared_ptr<const Model> model_;
  JumpingStep now_{100'000'000'000, 0, 0, 0, ""};
  JumpingEdge edges_[4];
  int contents_ = 0;
  std::vector<SentMarker> sent_;
  std::vector<JumpingStep> steps_;
  std::set<int> known_;  // sizes of contents that tf had in time
  std::deque<Copy> copies_;
  JumpsSeen seen_;
};

TEST(ObjectJumps, AreNowhereWhereNobodySaidSo) {
  JumpsSeen seen;
  for (int run = 1; run <= repetitions(kJumpRuns) && !testing::Test::HasFailure(); ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    JumpingScene scene(static_cast<std::uint64_t>(run));
    for (int step = 0; step < kJumpSteps && !testing::Test::HasFailure(); ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      scene.step();
    }
    seen.add(scene.seen());
  }
  std::cout << seen.placed << " placed, " << seen.of_another_era << " of them in another era, "
            << seen.placed_late << " after waiting; " << seen.incomplete << " incomplete; "
            << seen.held << " held and " << seen.not_held << " not; " << seen.stopping
            << " held in ~stopping and ~earliest; " << seen.copied_over_a_jump
            << " copies over a jump\n";
  const long runs = repetitions(kJumpRuns);
  EXPECT_GT(seen.of_another_era, runs);
  EXPECT_GT(seen.placed_late, runs);
  EXPECT_GT(seen.held, runs);
  EXPECT_GT(seen.not_held, runs);
  EXPECT_GT(seen.stopping, runs / 10);
  EXPECT_GT(seen.copied_over_a_jump, runs / 10);
}

}  // namespace
}  // namespace link_bounds
