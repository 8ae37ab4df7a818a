// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Random recordings: each place of a body between two messages, as dense samples of tf have it in
// the frame of a zone, belongs to a motion that is reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "testing/random_carriers.h"
#include "testing/recorded_testing.h"
#include "testing/sanitized.h"
#include "tools/bag_bounds/scene/recorded_scene.h"
#include "tools/bag_bounds/watch/body_motions.h"

namespace link_bounds {
namespace {

constexpr double kBodyTimeout = 0.5;   // s
constexpr double kBoxRounding = 1e-9;  // m
constexpr int kPlacesPerMotion = 8;

/// A motion that was told, with what it refers to.
struct ToldMotion {
  explicit ToldMotion(const BodyMotion& told) : motion(told), link(*told.link) {
    if (told.source_from_link) source_from_link = *told.source_from_link;
  }

  /// In the view.
  std::optional<Aabb> boxAt(const TransformBuffer& tf, std::int64_t stamp) const {
    const auto pose = tf.pose(motion.target, motion.source, stamp);
    if (!pose) return std::nullopt;
    return linkBox(link, motion.view_from_target.value_or(Eigen::Affine3d::Identity()) *
                             MatrixPose(*pose).affine * source_from_link);
  }

  BodyMotion motion;
  BoundedLink link;
  Eigen::Affine3d source_from_link = Eigen::Affine3d::Identity();
};

class RandomBodies {
 public:
  struct Counts {
    int told = 0, motions = 0, rests = 0, formers = 0;
  };

  explicit RandomBodies(std::uint64_t seed)
      : carriers_(seed, kBodyTimeout, 1), view_frame_(viewFrame(seed)) {
    std::vector<BoundedLink> links;
    for (int i = 0; i < RandomCarriers::kArms; ++i)
      links.push_back(meshLink(RandomCarriers::armName(i), seed + static_cast<std::uint64_t>(i)));
    auto model = std::make_shared<Model>(*modelOf("world", links));
    model->parameters.timeout = kBodyTimeout;
    scene_.adopt(model, carriers_.begin());
    if (!view_frame_.empty()) view_.emplace(view_frame_, scene_.scene(), tf(), rosNow());
    motions_.emplace(scene_.scene(), edges_, view_ ? &*view_ : nullptr);
    fixed_ = *scene_.scene().frames.fixedFrame();
    target_ = view_ ? view_->frame() : fixed_;
  }

  void receive() {
    const CarrierMessage message = carriers_.next();
    if (scene_.goesBackTo(message.time)) finish();
    takeMessage(scene_, message);
  }

  const Counts& counts() const { return counts_; }

 private:
  /// What is known of a body, or was known until it was replaced.
  struct Track {
    BoundedLink link;
    std::shared_ptr<const ObjectContent> object;
    TransformBuffer::Frame frame = 0;
    std::optional<Eigen::Affine3d> place;  ///< in the fixed frame, if it stands there
    std::int64_t stamp = 0;                ///< in the view; 0: it does not move
    std::int64_t ahead = 0;                ///< in the scene
  };

  struct Replaced {
    std::string name;
    Track track;
    std::int64_t until;
  };

  static std::string viewFrame(std::uint64_t seed) {
    const std::string frames[] = {"", "base", RandomCarriers::armName(1)};
    return frames[seed % 3];
  }

  TransformBuffer& tf() { return scene_.tf(); }
  ros::Time rosNow() const {
    return ros::Time().fromNSec(static_cast<std::uint64_t>(scene_.now()));
  }

  auto teller() {
    return [this](BodyNumber, const std::string& name, const BodyMotion& motion) {
      told_.emplace(name, motion);
    };
  }

  void look(bool is_tick) {
    if (!motions_) return;
    if (view_ && is_tick) view_->expire(rosNow());
    if (view_ && !is_tick) view_->update(rosNow());
    told_.clear();
    motions_->forEach(teller(), [this](BodyNumber, const std::string& name, const BoxState&,
                                       const BodyMotion* motion) {
      if (motion) told_.emplace(name, *motion);
    });
    counts_.told += static_cast<int>(told_.size());
    followView();
    std::map<std::string, Track> next;
    scene_.scene().forEach([&](const SceneBody& body) { compare(body, next); });
    tracks_ = std::move(next);
    compareReplaced();
  }

  /// A stand of the fixed frame in the view that is known without a gap.
  void followView() {
    const std::int64_t stamp = view_ ? view_->fixedStamp() : 0;
    if (stamp == 0 || stamp == view_stamp_) return;
    if (view_stamp_ == 0 || stamp < view_stamp_) view_since_ = stamp;
    view_stamp_ = stamp;
  }

  FrameView::Placed placed(const SceneBody& body) {
    if (view_) return view_->placed(body);
    const bool moves = body.state.box && !scene_.scene().boxSource(body).frame_from_body;
    return {body.state, !moves      ? 0
                        : body.link ? body.state.stamp
                                    : body.object->header.pose().stamp};
  }

  void compare(const SceneBody& body, std::map<std::string, Track>& next) {
    const FrameView::Placed now = placed(body);
    const auto found = tracks_.find(body.name);
    const bool has_source = body.link || body.state.box;
    if (!has_source) return;
    const BoxSource source = scene_.scene().boxSource(body);
    const bool is_known = found != tracks_.end() && found->second.object == source.object &&
                          found->second.place.has_value() == (source.frame_from_body != nullptr);
    if (found != tracks_.end() && source.object != found->second.object)
      noteReplaced(body.name, found->second, *source.object);
    Track track = is_known ? found->second : Track();
    if (is_known && track.stamp != 0 && !now.state.box) compareRest(body.name, track);
    if (!now.state.box) {
      track.ahead = 0;
      if (is_known) next.emplace(body.name, track);
      return;
    }
    track.link = source.bounded;
    track.object = source.object;
    track.frame = source.frame;
    if (source.frame_from_body) track.place = *source.frame_from_body;
    const bool is_first = body.link && track.stamp == 0;
    const std::int64_t begin = is_known && !is_first ? track.stamp : sinceOf(source);
    track.stamp = now.pose_stamp;
    track.ahead = view_ && !source.frame_from_body ? body.state.stamp : 0;
    if (begin != 0 && begin < track.stamp)
      compareMotion(body.name, track, {begin, track.stamp}, counts_.motions);
    next.emplace(body.name, track);
  }

  /// One that is placed once was there since its stamp, a link since tf knows it.
  std::int64_t sinceOf(const BoxSource& source) {
    if (!source.object) return oldestKnown(tf(), target_, source.frame);
    if (source.object->follows() || view_stamp_ == 0) return 0;
    return std::max({source.object->stamp, view_since_, oldestKnown(tf(), target_, source.frame)});
  }

  void noteReplaced(const std::string& name, const Track& track, const ObjectContent& by) {
    const bool stands = track.place && track.stamp != 0 && track.stamp >= view_since_;
    if (stands && !by.follows() && by.stamp > track.stamp)
      replaced_.push_back({name, track, by.stamp});
  }

  /// As far as the view has come.
  void compareReplaced() {
    for (Replaced& replaced : replaced_) {
      if (replaced.track.stamp < view_since_) replaced.until = 0;
      const MotionSpan span{replaced.track.stamp, std::min(replaced.until, view_stamp_)};
      if (span.begin >= span.end) continue;
      compareMotion(replaced.name, replaced.track, span, counts_.formers);
      replaced.track.stamp = span.end;
    }
  }

  void compareMotion(const std::string& name, const Track& track, MotionSpan span, int& count) {
    forEachPlace(span, [&](std::int64_t stamp) {
      const auto pose = tf().pose(target_, track.place ? fixed_ : track.frame, stamp);
      if (pose)
        expectTold(name, stamp,
                   linkBox(track.link, track.place ? MatrixPose(*pose).affine * *track.place
                                                   : MatrixPose(*pose).affine),
                   count);
    });
  }

  /// The view stays where it was last.
  void compareRest(const std::string& name, const Track& track) {
    const auto view = tf().pose(target_, fixed_, track.stamp);
    if (!view) return;
    forEachPlace({track.stamp, track.ahead}, [&](std::int64_t stamp) {
      const auto pose = tf().pose(fixed_, track.frame, stamp);
      if (pose)
        expectTold(name, stamp,
                   linkBox(track.link, MatrixPose(*view).affine * MatrixPose(*pose).affine),
                   counts_.rests);
    });
  }

  /// With both ends.
  template <class Visit>
  static void forEachPlace(MotionSpan span, Visit visit) {
    for (int k = 0; k <= kPlacesPerMotion && span.begin < span.end; ++k)
      visit(span.begin + (span.end - span.begin) * k / kPlacesPerMotion);
  }

  void expectTold(const std::string& name, std::int64_t stamp, const std::optional<Aabb>& box,
                  int& count) {
    if (!box) return;
    ++count;
    const auto [begin, end] = told_.equal_range(name);
    EXPECT_TRUE(
        std::any_of(begin, end, [&](const auto& told) { return holds(told.second, stamp, *box); }))
        << name << " at " << stamp << " in \"" << view_frame_ << "\", which "
        << (&count == &counts_.motions ? "moves"
            : &count == &counts_.rests ? "rests"
                                       : "was replaced");
  }

  /// It has the body there at that time, and not farther from its begin than its way.
  bool holds(const ToldMotion& told, std::int64_t stamp, const Aabb& box) {
    const BodyMotion& motion = told.motion;
    if (stamp < motion.span.begin || stamp > motion.span.end) return false;
    const auto found = told.boxAt(tf(), stamp);
    return found && isInside(*found, padded(box, kBoxRounding)) &&
           isInside(box, padded(*found, kBoxRounding)) &&
           (!(motion.way < 1e6) || isInside(box, padded(motion.before, motion.way + kBoxRounding)));
  }

  static bool isInside(const Aabb& box, const Aabb& outer) {
    return (box.min().array() >= outer.min().array()).all() &&
           (box.max().array() <= outer.max().array()).all();
  }

  /// Before tf forgets.
  void finish() {
    told_.clear();
    motions_->finish(teller());
    for (const auto& [name, track] : tracks_)
      if (track.stamp != 0) compareRest(name, track);
    tracks_.clear();
    replaced_.clear();
    view_stamp_ = view_since_ = 0;
  }

  RandomCarriers carriers_;
  const std::string view_frame_;
  RecordedScene scene_{[](const std::string&) { return LoadedMesh(); },
                       [this](std::int64_t) { look(false); },
                       [this](std::int64_t, bool is_tick) { look(is_tick); }};
  EdgeWays edges_{scene_.tf()};
  std::optional<FrameView> view_;
  std::optional<BodyMotions> motions_;
  TransformBuffer::Frame fixed_ = 0;
  TransformBuffer::Frame target_ = 0;
  std::multimap<std::string, ToldMotion> told_;
  std::map<std::string, Track> tracks_;
  std::vector<Replaced> replaced_;
  std::int64_t view_stamp_ = 0;
  std::int64_t view_since_ = 0;
  Counts counts_;
};

TEST(BodySequences, EachPlaceBetweenMessagesBelongsToAMotion) {
  constexpr int kRecordings = repetitions(300);
  RandomBodies::Counts sum;
  for (std::uint64_t seed = 1; seed <= kRecordings && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomBodies recording(seed);
    for (int i = 0; i < 200; ++i)
      recording.receive();
    const RandomBodies::Counts& counts = recording.counts();
    sum.told += counts.told;
    sum.motions += counts.motions;
    sum.rests += counts.rests;
    sum.formers += counts.formers;
  }
  std::cout << sum.told << " motions were told; places: " << sum.motions << " of motions, "
            << sum.rests << " of rests, " << sum.formers << " of what was replaced\n";
  EXPECT_GT(sum.motions, 1000 * kRecordings);
  EXPECT_GT(sum.rests, 10 * kRecordings);
  EXPECT_GT(sum.formers, kRecordings / 2);
}

/// Of what was before the first look, only what is there is kept.
TEST(BodySequences, AnObjectThatIsDeletedBeforeTheFirstLookIsForgotten) {
  const std::string arm = RandomCarriers::armName(0);
  RecordedScene scene([](const std::string&) { return LoadedMesh(); }, [](std::int64_t) {},
                      [](std::int64_t, bool) {});
  scene.adopt(modelOf("world", {meshLink(arm, 1)}), 1'000'000'000);
  EdgeWays edges(scene.tf());
  BodyMotions motions(scene.scene(), edges, nullptr);
  CarrierMessage message;
  message.time = 2'000'000'000;
  message.transforms = {
      edge("world", arm, 2, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero())};
  takeMessage(scene, message);
  message.transforms.clear();
  message.marker.header.frame_id = arm;
  message.marker.type = visualization_msgs::Marker::SPHERE;
  message.marker.pose.orientation.w = 1;
  message.marker.scale.x = message.marker.scale.y = message.marker.scale.z = 0.1;
  takeMessage(scene, message);
  motions.remember();
  std::weak_ptr<const ObjectContent> content;
  scene.scene().forEach([&](const SceneBody& body) {
    if (body.object) content = scene.scene().boxSource(body).object;
  });
  ASSERT_FALSE(content.expired());
  message.marker.action = visualization_msgs::Marker::DELETE;
  takeMessage(scene, message);
  motions.remember();
  EXPECT_TRUE(content.expired());
}

}  // namespace
}  // namespace link_bounds
