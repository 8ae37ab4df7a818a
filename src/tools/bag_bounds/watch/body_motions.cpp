// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/watch/body_motions.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "world/history/swept_box.h"

namespace link_bounds {
namespace {

/// Max number of followed frames; beyond it, all are forgotten, among them those of objects that
/// are gone.
constexpr std::size_t kMaxFollowed = 1000;

}  // namespace

FrameView::FrameView(const std::string& frame, Scene& scene, TransformBuffer& tf, ros::Time now)
    : scene_(scene), frames_(tf), links_(frames_) {
  frames_.setTarget(frame, scene.model()->parameters.timeout, now);
  links_.adopt(scene.links.sharedModel());
}

bool FrameView::update(ros::Time now) {
  if (followed_.size() > kMaxFollowed) followed_.clear();
  frames_.update(now);
  return links_.update();
}

bool FrameView::expire(ros::Time now) {
  frames_.expire(now);
  return links_.update();
}

const FramePose& FrameView::poseOf(const std::string& frame) {
  auto found = followed_.find(frame);
  if (found == followed_.end()) {
    TransformBuffer::Hold hold(frames_.tf(), frame);
    FrameTracker::Handle handle = frames_.follow(hold.frame());
    found = followed_.emplace(frame, Followed{std::move(hold), std::move(handle)}).first;
  }
  return found->second.handle.pose();
}

FrameView::Placed FrameView::placed(const SceneBody& body) {
  if (body.link) {
    const BoxState& state = links_.states()[*body.link];
    return {state, state.stamp};
  }
  Placed result;
  BoxState& state = result.state;
  if (!body.state.box) return result;
  const BoxSource source = scene_.boxSource(body);
  const FramePose& pose = poseOf(frames_.tf().name(source.frame));
  if (pose.problem != TransformProblem::kNone) return result;
  result.pose_stamp = pose.stamp;
  const Eigen::Affine3d& frame_pose = pose.fixed_from_frame.affine;
  state.box = linkBox(source.bounded,
                      source.frame_from_body ? frame_pose * *source.frame_from_body : frame_pose);
  state.stamp = std::max(pose.stamp, body.state.stamp);
  return result;
}

std::int64_t FrameView::fixedStamp() {
  const FramePose& pose = poseOf(scene_.model()->fixed_frame);
  return pose.problem == TransformProblem::kNone ? pose.stamp : 0;
}

double radiusOf(const BodyMotion& motion) {
  const double radius = radiusOf(*motion.link);
  if (!motion.source_from_link) return radius;
  const Eigen::Affine3d& moved = *motion.source_from_link;
  return moved.translation().norm() + moved.linear().norm() * radius;
}

BodyMotions::BodyMotions(Scene& scene, EdgeWays& edges, FrameView* view)
    : scene_(scene),
      view_(view),
      ways_(edges, view ? view->frame() : *scene.frames.fixedFrame()),
      scene_ways_(edges, *scene.frames.fixedFrame()),
      target_(view ? view->frame() : *scene.frames.fixedFrame()),
      last_links_(scene.model()->links.size()),
      last_number_(last_links_.size()) {
  for (std::size_t i = 0; i < last_links_.size(); ++i) {
    radii_.push_back(radiusOf(scene.model()->links[i]));
    last_links_[i].number = i;
  }
}

void BodyMotions::remember() {
  ++pass_;
  scene_.forEach([this](const SceneBody& body) {
    Last& last = lastOf(body);
    const FrameView::Placed placed = placedIn(body);
    if (!placed.state.box) return;
    const BoxSource source = scene_.boxSource(body);
    if (source.frame_from_body) return;
    last.stamp = placed.pose_stamp;
    last.box = *placed.state.box;
    last.is_new = true;
    last.object = source.object;
    last.place.reset();
  });
  forgetObjects([](BodyNumber, const std::string&, const BodyMotion&) {});
}

FrameView::Placed BodyMotions::placedIn(const SceneBody& body) {
  return view_ ? view_->placed(body) : placedInScene(body);
}

/// In the scene's fixed frame, an object that does not follow a frame stands still.
FrameView::Placed BodyMotions::placedInScene(const SceneBody& body) const {
  if (body.link) return {body.state, body.state.stamp};
  const bool moves = body.state.box && !scene_.boxSource(body).frame_from_body;
  return {body.state, moves ? body.object->header.pose().stamp : 0};
}

BodyMotions::Last& BodyMotions::lastOf(const SceneBody& body) {
  if (body.link) return last_links_[*body.link];
  const auto [entry, is_new] = last_objects_.try_emplace(*body.key);
  if (is_new) entry->second.number = ++last_number_;
  entry->second.seen = pass_;
  return entry->second;
}

void BodyMotions::followView() {
  const std::int64_t stamp = view_ ? view_->fixedStamp() : 0;
  if (stamp == 0 || stamp == view_stamp_) return;
  const std::int64_t last = std::exchange(view_stamp_, stamp);
  if (last == 0 || stamp < last) view_since_ = stamp;
}

/// Sets the begin of a motion: the box in the view at the earliest time that tf knows, for a link
/// or an object that was placed once. If a link has no pose then, its motion will be undecided.
void BodyMotions::beginKnown(Last& last, const BoxSource& source,
                             const FrameView::Placed& placed) const {
  const bool is_link = !source.object;
  last.stamp = 0;
  if (!is_link && (view_stamp_ == 0 || !source.frame_from_body || source.object->follows())) return;
  std::int64_t since = oldestKnown(scene_.frames.tf(), target_, source.frame);
  if (!is_link) since = std::max({since, source.object->stamp, view_since_});
  const auto pose = scene_.frames.tf().pose(target_, source.frame, since);
  const Eigen::Affine3d frame_from_body =
      source.frame_from_body ? *source.frame_from_body : Eigen::Affine3d::Identity();
  auto box =
      pose ? linkBox(source.bounded, MatrixPose(*pose).affine * frame_from_body) : std::nullopt;
  if (!box && is_link) box = placed.state.box;
  if (!box) return;
  last.stamp = since;
  last.box = *box;
  last.is_new = true;
  last.object = source.object;
}

bool BodyMotions::hasRest(const Last& last, const SceneBody& body) const {
  if (last.stamp == 0 || last.ahead <= last.stamp) return false;
  return (body.link || body.state.box) && scene_.boxSource(body).object == last.object;
}

/// The motion in the scene's fixed frame since the view was last known.
const BodyMotion& BodyMotions::rest(Last& last, const SceneBody& body) {
  const BoxSource source = scene_.boxSource(body);
  const MotionSpan span{last.stamp, std::exchange(last.ahead, 0)};
  const TransformBuffer::Frame fixed = *scene_.frames.fixedFrame();
  const auto pose = scene_.frames.tf().pose(target_, fixed, span.begin);
  motion_ = {span,
             last.box,
             std::numeric_limits<double>::infinity(),
             fixed,
             source.frame,
             &source.bounded,
             source.frame_from_body};
  if (!pose) return motion_;
  motion_.view_from_target = MatrixPose(*pose).affine;
  motion_.way = scene_ways_.of(source.frame, radiusOf(motion_), span);
  return motion_;
}

/// Forgets objects whose time is over, or for which the view was lost.
void BodyMotions::forgetFormers(Last& last) const {
  const auto is_over = [this](const Former& former) {
    return former.stamp >= former.until || former.stamp < view_since_;
  };
  last.formers.erase(std::remove_if(last.formers.begin(), last.formers.end(), is_over),
                     last.formers.end());
}

/// Notes an object that was replaced, even if the view is lost now.
void BodyMotions::noteReplaced(Last& last, const SceneBody& body) const {
  if (!last.place || !body.state.box || last.stamp == 0 || last.stamp < view_since_) return;
  const BoxSource source = scene_.boxSource(body);
  if (source.object == last.object || source.object->follows()) return;
  if (source.object->stamp > last.stamp)
    last.formers.push_back({last.object, *last.place, last.box, last.stamp, source.object->stamp});
  last.forget();
}

/// The motion in the view up to its newest stamp; null if there is none.
const BodyMotion* BodyMotions::untilReplaced(Former& former) {
  const MotionSpan span{former.stamp, std::min(former.until, view_stamp_)};
  if (span.begin >= span.end) return nullptr;
  const TransformBuffer::Frame fixed = *scene_.frames.fixedFrame();
  motion_ = {span,
             former.box,
             0,
             target_,
             fixed,
             &former.object->bounded,
             &former.place,
             Eigen::Affine3d::Identity(),
             view_stamp_ - span.end};
  motion_.way = ways_.of(motion_.source, radiusOf(motion_), span);
  former.stamp = span.end;
  if (former.stamp == former.until) return &motion_;
  const auto pose = scene_.frames.tf().pose(target_, fixed, former.stamp);
  const auto box = pose ? linkBox(former.object->bounded, MatrixPose(*pose).affine * former.place)
                        : std::nullopt;
  if (box) former.box = *box;
  if (!box) former.until = former.stamp;
  return &motion_;
}

const BodyMotion* BodyMotions::next(Last& last, const SceneBody& body,
                                    const FrameView::Placed& placed) {
  if (!placed.state.box) return nullptr;
  const BoxSource source = scene_.boxSource(body);
  const bool is_new = body.link ? last.stamp == 0 : last.object != source.object;
  if (is_new && placed.pose_stamp != 0) beginKnown(last, source, placed);
  const bool has_moved =
      last.object == source.object && last.stamp != 0 && last.stamp < placed.pose_stamp;
  if (has_moved) {
    motion_ = {{last.stamp, placed.pose_stamp}, last.box, 0, target_, source.frame, &source.bounded,
               source.frame_from_body};
    const double radius = body.link ? radii_[*body.link] : radiusOf(motion_);
    motion_.way = ways_.of(source.frame, radius, motion_.span);
    motion_.is_begin_new = last.is_new;
  }
  last.stamp = placed.pose_stamp;
  last.ahead = view_ && !source.frame_from_body ? body.state.stamp : 0;
  last.box = *placed.state.box;
  last.is_new = false;
  last.object = source.object;
  last.place = source.frame_from_body ? std::optional(*source.frame_from_body) : std::nullopt;
  return has_moved ? &motion_ : nullptr;
}

}  // namespace link_bounds
