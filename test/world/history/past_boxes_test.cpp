// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes at any time, in any frame, of any names: beside tf2's lookupTransform and a loop over all
// vertices.
#include "world/history/past_boxes.h"

#include <iostream>
#include <set>

#include "testing/beside_tf2.h"
#include "testing/sanitized.h"
#include "world/history/pose_gap.h"
#include "world/history/scene_copy.h"

namespace link_bounds {
namespace {

constexpr std::chrono::nanoseconds kStep(0);  // a few bodies or an edge at a time
constexpr int kLinks = 8;
constexpr int kVertices = 30;
constexpr int kMissing = 3;  // the link that lacks a mesh
const ros::Time kNow(1);

bool goOn() {
  return false;
}

std::vector<std::vector<Eigen::Vector3f>> verticesOfLinks() {
  brute_force::Random random(7);
  std::vector<std::vector<Eigen::Vector3f>> result;
  for (int i = 0; i < kLinks; ++i)
    result.push_back(random.points(kVertices, 0.5));
  return result;
}

/// One random life of tf, and a scene of links and objects in it.
struct Entry {
  std::string name;
  BoxState state;
};

/// Each body of the copy, with or without a box in the moment, which has no other ones.
std::vector<Entry> entriesOf(const PastScene& scene, const Moment& moment) {
  std::vector<Entry> result;
  auto body = moment.bodies.begin();
  for (const PastBody& past : scene.bodies) {
    Entry entry{past.bounded->name, {}};
    const auto& incomplete = moment.incomplete;
    entry.state.incomplete =
        std::find(incomplete.begin(), incomplete.end(), entry.name) != incomplete.end();
    if (body != moment.bodies.end() && moment.name(*body) == entry.name) {
      entry.state.box = body->box;
      entry.state.stamp = body->stamp;
      ++body;
    }
    result.push_back(std::move(entry));
  }
  EXPECT_TRUE(body == moment.bodies.end());
  return result;
}

class RandomRequests {
 public:
  RandomRequests(std::uint64_t seed, Oddity oddity)
      : random_(seed, oddity), numbers_(seed), vertices_(verticesOfLinks()) {
    std::vector<BoundedLink> links;
    for (int i = 0; i < kLinks; ++i) {
      Shape shape;
      shape.points = std::make_shared<const PointSet>(vertices_[static_cast<std::size_t>(i)]);
      links.push_back({frameName(i), {shape}, 0, i == kMissing ? "a mesh is missing" : ""});
    }
    scene_.adopt(modelOf(frameName(0), links), kNow);
  }

  void receive() {
    both_.add(random_.next());
    scene_.update(kNow);
  }

  void jump() {
    both_.tf2.clear();
    both_.ours.clear();
    scene_.restart(kNow);
  }

  void ask() {
    const BoxRequest request = randomRequest();
    SceneCopy copy(request, scene_.links.sharedModel());
    while (!copy.proceed(scene_, kNow, kStep)) {
    }
    const std::unique_ptr<PastScene> past = copy.take();
    const std::set<std::string> names(request.names.begin(), request.names.end());
    if (expectRefusal(request, names, *past)) return;
    const PastBoxes found = pastBoxes(*past, request, goOn);
    const std::vector<Entry> entries = entriesOf(*past, found.moment);
    std::size_t entry = 0;
    std::string first_incomplete;
    for (std::size_t i = 0; i < kLinks; ++i) {
      const std::string& name = scene_.model()->links[i].name;
      if (!names.empty() && names.count(name) == 0) continue;
      ASSERT_LT(entry, entries.size());
      EXPECT_EQ(entries[entry].name, name);
      const BoxState& state = entries[entry++].state;
      EXPECT_EQ(state.incomplete, !state.box || i == kMissing);
      if (state.incomplete && first_incomplete.empty()) first_incomplete = name;
      if (request.stamp == 0) {
        expectLatest(request, i, state);
      } else {
        expectAt(request, i, state);
      }
    }
    EXPECT_EQ(entry, entries.size());
    EXPECT_EQ(found.problem.substr(0, found.problem.find(':')), first_incomplete);
    EXPECT_EQ(found.late, 0u);
    expectNoneIsWrongWhenGivenUp(*past, request);
  }

  int boxes() const { return boxes_; }
  int without() const { return without_; }
  int refused() const { return refused_; }
  int givenUp() const { return given_up_; }

 private:
  int pick(int count) { return random_.pick(count); }

  BoxRequest randomRequest() {
    BoxRequest request;
    request.stamp = pick(8) == 0 ? 0 : pickTime();
    if (pick(3) > 0) request.frame = frameName(pick(random_.frames()));
    if (pick(30) == 0) request.frame = "never_sent";
    for (int i = pick(2) * pick(5); i > 0; --i)
      request.names.push_back(frameName(pick(kLinks)));
    if (pick(30) == 0) request.names.push_back(pick(2) ? "nobody" : "no/1");
    return request;
  }

  /// Stamps, where tf2 does not always interpolate, times between them, and far from them.
  std::int64_t pickTime() {
    const std::int64_t stamp = both_.pickStamp(random_).value();
    const double distance = pick(10) == 0 ? 2e10 : 1e7;
    return stamp + pick(2) * static_cast<std::int64_t>(numbers_.uniform(-distance, distance));
  }

  bool expectRefusal(const BoxRequest& request, const std::set<std::string>& names,
                     const PastScene& past) {
    const bool has_frame = request.frame != "never_sent" && isMet(request.frame);
    const bool has_names = names.count("nobody") + names.count("no/1") == 0;
    const std::string reason = whyRefused(past);
    EXPECT_EQ(reason.empty(), has_frame && has_names) << reason;
    EXPECT_FALSE(both_.ours.find("never_sent"));
    refused_ += !reason.empty();
    return !reason.empty();
  }

  bool isMet(const std::string& name) const {
    const auto frame = both_.ours.find(name);
    return name.empty() || name == frameName(0) || (frame && both_.ours.isMet(*frame));
  }

  static std::string targetOf(const BoxRequest& request) {
    return request.frame.empty() ? frameName(0) : request.frame;
  }

  /// At any moment, in turns of any length, at one time and during a span.
  void expectNoneIsWrongWhenGivenUp(PastScene& past, BoxRequest request) {
    request.span = pick(2) * static_cast<std::int64_t>(numbers_.uniform(0, 1e8));
    const std::vector<Entry> all = entriesOf(past, pastBoxes(past, request, goOn).moment);
    int looks = pick(40);
    PastBoxMaker maker(past, request);
    while (!maker.proceed(kStep, [&looks] { return looks-- <= 0; })) {
    }
    const PastBoxes given_up = maker.take();
    const std::vector<Entry> some = entriesOf(past, given_up.moment);
    std::size_t late = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (isSame(some[i].state, all[i].state) && late == 0) continue;
      ++late;
      EXPECT_FALSE(some[i].state.box);
      EXPECT_TRUE(some[i].state.incomplete);
    }
    EXPECT_GE(given_up.late, late);
    given_up_ += late > 0;
  }

  void expectAt(const BoxRequest& request, std::size_t i, const BoxState& state) {
    const BoundedLink& link = scene_.model()->links[i];
    const std::string target = targetOf(request);
    if (target == link.name) {
      EXPECT_TRUE(isSame(state.box, linkBox(link, Eigen::Affine3d::Identity())));
      EXPECT_EQ(state.stamp, 0);
      return;
    }
    const auto in_tf2 = both_.lookUp(
        target, link.name, ros::Time().fromNSec(static_cast<std::uint64_t>(request.stamp)));
    const auto pose =
        both_.ours.pose(both_.ours.frame(target), both_.ours.frame(link.name), request.stamp);
    ASSERT_EQ(pose.has_value(), in_tf2.has_value());
    ASSERT_EQ(state.box.has_value(), in_tf2.has_value());
    if (!pose) {
      ++without_;
      return;
    }
    ++boxes_;
    EXPECT_TRUE(isSame(state.box, linkBox(link, MatrixPose(*pose).affine)));
    EXPECT_TRUE(state.stamp == request.stamp || state.stamp == 0);
    const Aabb exact = brute_force::box(vertices_[i], Eigen::Affine3d(toIsometry(*in_tf2)));
    EXPECT_LT((state.box->min() - exact.min()).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((state.box->max() - exact.max()).cwiseAbs().maxCoeff(), 1e-10);
  }

  void expectLatest(const BoxRequest& request, std::size_t i, const BoxState& state) {
    const BoundedLink& link = scene_.model()->links[i];
    FrameTracker tracker(both_.ours);
    tracker.setTarget(targetOf(request), 0, kNow);
    const auto handle = tracker.follow(link.name);
    const FramePose& pose = handle.pose();
    ASSERT_EQ(state.box.has_value(), pose.problem == TransformProblem::kNone);
    if (request.frame.empty() || request.frame == frameName(0)) {
      EXPECT_TRUE(isSame(state, scene_.links.states()[i]));
    }
    if (!state.box) return;
    EXPECT_EQ(state.stamp, pose.stamp);
    EXPECT_TRUE(isSame(state.box, linkBox(link, pose.fixed_from_frame.affine)));
  }

  RandomTf random_;
  brute_force::Random numbers_;
  BesideTf2 both_;
  Scene scene_{both_.ours};
  std::vector<std::vector<Eigen::Vector3f>> vertices_;  ///< by link
  int boxes_ = 0;
  int without_ = 0;
  int refused_ = 0;
  int given_up_ = 0;
};

TEST(PastBoxes, AreThoseOfTf2AndAllVertices) {
  constexpr int kRequests = repetitions(10000);
  constexpr int kMessages = 100;
  int requests = 0;
  int boxes = 0;
  int without = 0;
  int refused = 0;
  int given_up = 0;
  for (std::uint64_t seed = 1; requests < kRequests && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomRequests random(seed, seed % 3 == 0 ? Oddity::kLoops : Oddity::kUneven);
    for (int i = 0; i < 20; ++i)
      random.receive();
    for (int i = 0; i < kMessages; ++i, ++requests) {
      random.receive();
      if (i == kMessages / 2) random.jump();
      random.ask();
    }
    boxes += random.boxes();
    without += random.without();
    refused += random.refused();
    given_up += random.givenUp();
  }
  std::cout << requests << " requests: " << boxes << " boxes, " << without << " without, "
            << refused << " requests refused, " << given_up << " given up once more\n";
  EXPECT_GT(boxes, kRequests / 2);
  EXPECT_GT(without, kRequests);
  EXPECT_GT(refused, kRequests / 50);
  EXPECT_GT(given_up, kRequests / 50);
}

class WhyNoPoseTest : public testing::Test {
 protected:
  void send(const std::string& parent, const std::string& child, double stamp,
            bool is_static = false) {
    tf_.add({edge(parent, child, stamp, Eigen::Quaterniond::Identity(), {1, 0, 0})}, is_static,
            kNow);
  }

  std::string why(double stamp) {
    const auto time = static_cast<std::int64_t>(stamp * 1e9);
    TfExcerpt excerpt(time, 0, 0);
    const auto target = excerpt.add(tf_, tf_.frame("map"));
    const auto source = excerpt.add(tf_, tf_.frame("tip"));
    while (!excerpt.copy(tf_, kStep)) {
    }
    EXPECT_FALSE(excerpt.buffer().pose(target, source, time));
    return whyNoPose(excerpt, target, source, time);
  }

  TransformBuffer tf_;
};

TEST_F(WhyNoPoseTest, NamesBothFrames) {
  EXPECT_EQ(why(5), "no transform from \"tip\" to \"map\"");
}

TEST_F(WhyNoPoseTest, SaysHowFarTheHistoryOfThePathReaches) {
  for (const double stamp : {10.0, 11.0, 12.5})
    send("map", "base", stamp);
  for (const double stamp : {10.25, 11.0, 12.0})
    send("base", "arm", stamp);
  send("arm", "tip", 0, true);
  EXPECT_EQ(why(5),
            "no transform from \"tip\" to \"map\" at 5.0; tf's history of that path reaches from "
            "10.25 to 12.0");
  EXPECT_NE(why(12.2).find("at 12.2; tf's history"), std::string::npos) << why(12.2);
}

TEST_F(WhyNoPoseTest, DoesNotCountWhatTfForgotDuringAPause) {
  for (const double stamp : {10.0, 11.0, 22.0})
    send("map", "tip", stamp);
  const std::string reason = why(15);
  EXPECT_NE(reason.find("reaches from 22.0 to 22.0"), std::string::npos) << reason;
}

TEST_F(WhyNoPoseTest, KnowsPathsThatAreNeverCompleteAndOtherParents) {
  send("map", "base", 10);
  send("base", "tip", 30);
  EXPECT_NE(why(10).find("has no time at which it knows all"), std::string::npos) << why(10);
  send("elsewhere", "tip", 31);
  send("map", "tip", 32);
  EXPECT_NE(why(31.5).find("other parents then"), std::string::npos) << why(31.5);
}

TEST(SecondsText, HasTheDigitsThatCount) {
  EXPECT_EQ(secondsText(0), "0.0");
  EXPECT_EQ(secondsText(1500000000), "1.5");
  EXPECT_EQ(secondsText(1700000000000000001), "1700000000.000000001");
  EXPECT_EQ(secondsText(-250000000), "-0.25");
  EXPECT_EQ(secondsText(-351303523606343508), "-351303523.606343508");
}

ObjectContent cuboid(const std::string& name) {
  ObjectContent content;
  content.bounded.name = name;
  content.bounded.shapes = {{nullptr, Solid::kBox, {1, 2, 3}, Eigen::Affine3d::Identity()}};
  content.frame = "map";
  return content;
}

TEST(PastBoxes, ObjectsAreCopiedOnceEachWhileOthersComeAndGo) {
  constexpr int kObjects = 40;
  TransformBuffer tf;
  Scene scene(tf);
  scene.adopt(modelOf("map", {}), kNow);
  const auto key = [](int i) { return ObjectKey{"o", 100 + i}; };
  const auto put = [&](int i) { scene.objects.put(key(i), cuboid(objectName(key(i))), kNow); };
  std::vector<std::string> expected;
  for (int i = 0; i < kObjects; ++i) {
    put(2 * i);
    expected.push_back(objectName(key(2 * i)));
  }
  SceneCopy copy({}, scene.links.sharedModel());
  for (int i = 0; !copy.proceed(scene, kNow, kStep); ++i) {
    put(2 * i + 1);
    scene.objects.remove(key(2 * i + 1));
    scene.objects.remove(key(0));
    put(0);
  }
  const std::unique_ptr<PastScene> past = copy.take();
  std::vector<std::string> names;
  for (const PastBody& body : past->bodies)
    names.push_back(body.bounded->name);
  EXPECT_EQ(names, expected);
}

TEST(PastBoxes, ANeighbourIsWhereItsNewestMessagePutIt) {
  TransformBuffer tf;
  Scene scene(tf);
  scene.adopt(modelOf("map", {}), kNow);
  ObjectContent content = cuboid("/other/arm");
  content.stamp = 500;
  content.is_neighbour = true;
  scene.objects.put(*parseObjectName(content.bounded.name), content, kNow);
  for (const std::int64_t stamp : {0, 300, 700}) {
    BoxRequest request;
    request.stamp = stamp;
    SceneCopy copy(request, scene.links.sharedModel());
    while (!copy.proceed(scene, kNow, kStep)) {
    }
    const PastBoxes found = pastBoxes(*copy.take(), request, goOn);
    EXPECT_TRUE(found.moment.incomplete.empty());
    ASSERT_EQ(found.moment.bodies.size(), 1u);
    const Moment::Body& body = found.moment.bodies[0];
    EXPECT_EQ(found.moment.name(body), "/other/arm");
    EXPECT_NEAR(body.box.max().z(), 1.5, 1e-12);
    EXPECT_EQ(found.moment.header.stamp.toNSec(), stamp == 0 ? 500u : static_cast<unsigned>(stamp));
    if (stamp == 0) {
      EXPECT_EQ(body.stamp, 500);
    }
  }
}

}  // namespace
}  // namespace link_bounds
