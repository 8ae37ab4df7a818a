// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds an object anew when its content, the pose of its frame, or its age gives cause.
#include "node/objects/live_objects.h"

#include <algorithm>
#include <utility>

namespace link_bounds {
namespace {

using Trouble = LiveObject::Trouble;

/// How long to wait for a transform if nothing ever becomes stale [ROS s].
constexpr double kPatience = 10;

/// Stamps that are less ahead of the clock [ns] come from clocks that differ a little.
constexpr std::int64_t kFarAhead = 500'000'000;

/// Differences of ros::Time throw where they exceed a ros::Duration.
std::int64_t nanoseconds(ros::Time time) {
  return static_cast<std::int64_t>(time.toNSec());
}

Trouble toTrouble(FollowedFrame::Trouble trouble) {
  switch (trouble) {
    case FollowedFrame::Trouble::kNone:
      return Trouble::kNone;
    case FollowedFrame::Trouble::kNoTransform:
      return Trouble::kNoTransform;
    case FollowedFrame::Trouble::kStale:
      return Trouble::kStale;
  }
  return Trouble::kNone;
}

/// 0 if it is for ever.
std::int64_t lifetime(const LiveObject& object) {
  return std::max<std::int64_t>(object.content.lifetime.toNSec(), 0);
}

/// How much of the lifetime has passed.
std::int64_t elapsed(const LiveObject& object, std::int64_t now) {
  return std::min(now - object.received, lifetime(object));
}

bool hasExpired(const LiveObject& object, std::int64_t now) {
  return lifetime(object) > 0 && elapsed(object, now) == lifetime(object);
}

}  // namespace

void LiveObjects::adopt(const std::string& fixed_frame, double timeout, TransformSource& tf,
                        ros::Time now) {
  const FollowedFrame::Frame frame = tf.tree().frame(fixed_frame);
  const bool is_moved = target_ && target_->fixed_frame != frame;
  target_ = FollowedFrame::Target{frame, timeout};
  fixed_frame_name_ = fixed_frame;
  if (is_moved) moveTo(frame);
  const std::int64_t start = observe(now);
  for (auto& [key, object] : objects_)
    object.waiting_since = start;
  refreshAll(tf, now);
}

/// No number of the old frame remains.
void LiveObjects::moveTo(FollowedFrame::Frame fixed_frame) {
  carries_.clear();
  for (auto& [key, object] : objects_) {
    object.state.box.reset();
    if (object.trouble == Trouble::kGivenUp) object.trouble = Trouble::kNone;
    if (!object.placement || object.placement->fixed_frame == fixed_frame) continue;
    carries_.emplace(object.placement->fixed_frame, std::nullopt);
  }
}

/// True if there is a new one. Those that are stale or not finite are not taken, for they stay.
bool LiveObjects::findCarries(const TransformSource& tf, ros::Time now) {
  bool is_found = false;
  for (auto& [frame, fixed_from_frame] : carries_) {
    if (fixed_from_frame) continue;
    FollowedFrame followed(frame);
    followed.refresh(*target_, tf, now);
    const Eigen::Isometry3d& pose = followed.pose().world_from_link;
    if (followed.trouble() != FollowedFrame::Trouble::kNone || !pose.matrix().allFinite()) continue;
    fixed_from_frame = pose;
    is_found = true;
  }
  return is_found;
}

/// Fixed from header frame, if the placement is known in the present fixed frame.
std::optional<Eigen::Isometry3d> LiveObjects::carried(const Placement& placement) const {
  if (placement.fixed_frame == target_->fixed_frame) return placement.fixed_from_header;
  const std::optional<Eigen::Isometry3d>& carry = carries_.at(placement.fixed_frame);
  if (!carry) return std::nullopt;
  return *carry * placement.fixed_from_header;
}

std::int64_t LiveObjects::observe(ros::Time now) {
  last_now_ = std::max(last_now_, nanoseconds(now));
  return nanoseconds(now);
}

/// What was sent before the clock jumped back may arrive after it.
std::int64_t LiveObjects::stampOf(const ObjectContent& content, std::int64_t now) const {
  const bool is_late = content.stamp > now + kFarAhead && content.stamp <= newest_now_;
  return is_late ? now : content.stamp;
}

bool LiveObjects::put(const ObjectKey& key, ObjectContent content, TransformSource& tf,
                      ros::Time now) {
  const auto [entry, is_new] = objects_.try_emplace(key);
  LiveObject& object = entry->second;
  object.received = observe(now);
  object.waiting_since = object.received;
  object.content.lifetime = content.lifetime;
  if (!is_new && object.trouble != Trouble::kGivenUp && isSame(object.content, content)) {
    return false;
  }
  if (!is_new) release(object);
  object.content = std::move(content);
  object.boxes = LinkBoxes({object.content.bounded});
  object.trouble = Trouble::kNone;
  object.stamp = stampOf(object.content, object.received);
  object.placement.reset();
  if (!object.content.frame.empty()) object.frame = tf.tree().frame(object.content.frame);
  follow(object, tf, now);
  return refresh(object, tf, now) || is_new;
}

bool LiveObjects::remove(const ObjectKey& key) {
  const auto found = objects_.find(key);
  if (found == objects_.end()) return false;
  erase(found);
  return true;
}

bool LiveObjects::removeAll() {
  const bool is_changed = !objects_.empty();
  objects_.clear();
  frames_.clear();
  waiting_ = 0;
  return is_changed;
}

void LiveObjects::follow(LiveObject& object, const TransformSource& tf, ros::Time now) {
  if (!object.content.follows()) return;
  const auto [entry, is_new] =
      frames_.try_emplace(object.frame, HeaderFrame{FollowedFrame(object.frame), 0, false});
  ++entry->second.users;
  if (is_new && target_) entry->second.followed.refresh(*target_, tf, now);
}

/// Takes back what follow() and refresh() counted.
void LiveObjects::release(const LiveObject& object) {
  if (object.trouble == Trouble::kWaiting) --waiting_;
  if (!object.content.follows()) return;
  const auto frame = frames_.find(object.frame);
  if (--frame->second.users == 0) frames_.erase(frame);
}

LiveObjects::Objects::iterator LiveObjects::erase(Objects::iterator object) {
  release(object->second);
  return objects_.erase(object);
}

bool LiveObjects::fillMesh(const std::string& uri, const LoadedMesh& mesh,
                           const TransformSource& tf, ros::Time now) {
  bool is_changed = false;
  for (auto& [key, object] : objects_) {
    BoundedLink& bounded = object.content.bounded;
    if (object.content.mesh_uri != uri) continue;
    if (bounded.shapes.front().points == mesh.points && bounded.missing == mesh.error) continue;
    bounded.shapes.front().points = mesh.points;
    bounded.missing = mesh.error;
    object.boxes = LinkBoxes({bounded});
    is_changed |= refresh(object, tf, now);
  }
  return is_changed;
}

bool LiveObjects::update(const TransformSource& tf, ros::Time now) {
  observe(now);
  past_pose_.reset();
  if (!target_) return false;
  const bool paths_may_differ = structure_ != tf.tree().structure();
  structure_ = tf.tree().structure();
  bool is_news = false;
  for (auto& [frame, header] : frames_) {
    header.is_news = header.followed.update(*target_, tf, now, paths_may_differ);
    is_news |= header.is_news;
  }
  bool is_changed = findCarries(tf, now) && refreshNotCarried(tf, now);
  is_changed |= waiting_ > 0 && refreshWaiting(tf, now);
  if (!is_news) return is_changed;
  for (auto& [key, object] : objects_) {
    if (object.content.follows() && frames_.at(object.frame).is_news) {
      is_changed |= refresh(object, tf, now) || !object.state.incomplete;
    }
  }
  return is_changed;
}

bool LiveObjects::refreshNotCarried(const TransformSource& tf, ros::Time now) {
  bool is_changed = false;
  for (auto& [key, object] : objects_) {
    if (object.trouble == Trouble::kNotCarried) is_changed |= refresh(object, tf, now);
  }
  return is_changed;
}

bool LiveObjects::refreshWaiting(const TransformSource& tf, ros::Time now) {
  bool is_changed = false;
  for (auto& [key, object] : objects_) {
    if (object.trouble != Trouble::kWaiting) continue;
    is_changed |= refresh(object, tf, now);
    if (object.trouble == Trouble::kGivenUp) given_up_.push_back(key);
  }
  return is_changed;
}

bool LiveObjects::refreshAll(const TransformSource& tf, ros::Time now) {
  past_pose_.reset();
  if (!target_) return false;
  structure_ = tf.tree().structure();
  findCarries(tf, now);
  for (auto& [frame, header] : frames_)
    header.followed.refresh(*target_, tf, now);
  bool is_changed = false;
  for (auto& [key, object] : objects_)
    is_changed |= refresh(object, tf, now);
  return is_changed;
}

bool LiveObjects::restart(const TransformSource& tf, ros::Time now) {
  const std::int64_t start = nanoseconds(now);
  bool is_changed = false;
  for (auto& [key, object] : objects_) {
    object.received = start - elapsed(object, last_now_);
    object.waiting_since = start;
    object.stamp = std::min(object.stamp, start);
    is_changed |= object.state.stamp > start;
    object.state.stamp = std::min(object.state.stamp, start);
  }
  newest_now_ = std::max(newest_now_, last_now_);
  last_now_ = start;
  is_changed |= refreshAll(tf, now);
  return is_changed;
}

bool LiveObjects::expire(const TransformSource& tf, ros::Time now) {
  const std::int64_t time = observe(now);
  bool is_changed = false;
  for (auto entry = objects_.begin(); entry != objects_.end();) {
    const bool is_over = hasExpired(entry->second, time);
    is_changed |= is_over;
    entry = is_over ? erase(entry) : std::next(entry);
  }
  if (!target_) return is_changed;
  bool is_stale = false;
  for (auto& [frame, header] : frames_) {
    header.is_news = header.followed.expire(*target_, tf, now);
    is_stale |= header.is_news;
  }
  is_changed |= waiting_ > 0 && refreshWaiting(tf, now);
  if (!is_stale) return is_changed;
  for (auto& [key, object] : objects_) {
    if (object.content.follows() && frames_.at(object.frame).is_news) refresh(object, tf, now);
  }
  return true;
}

bool LiveObjects::refresh(LiveObject& object, const TransformSource& tf, ros::Time now) {
  if (object.trouble == Trouble::kWaiting) --waiting_;
  BoxState state;
  const Trouble before = std::exchange(object.trouble, place(object, tf, now, state));
  if (object.trouble == Trouble::kWaiting) ++waiting_;
  const bool is_loading = object.content.isLoading();
  if (object.trouble == Trouble::kWaiting || is_loading) state = object.state;
  state.incomplete =
      object.trouble != Trouble::kNone || is_loading || !object.content.bounded.isWhole();
  const bool is_changed = before != object.trouble || !isSame(state, object.state);
  object.state = state;
  return is_changed;
}

Trouble LiveObjects::place(LiveObject& object, const TransformSource& tf, ros::Time now,
                           BoxState& state) {
  if (!target_) return Trouble::kNoTransform;
  if (!object.content.bounded.isWhole() || object.content.isLoading()) return Trouble::kNone;
  return object.content.follows() ? placeFollowing(object, state)
                                  : placeOnce(object, tf, now, state);
}

Trouble LiveObjects::placeFollowing(LiveObject& object, BoxState& state) {
  const FollowedFrame& frame = frames_.at(object.frame).followed;
  if (frame.trouble() != FollowedFrame::Trouble::kNone) return toTrouble(frame.trouble());
  object.boxes.update(0, frame.pose().world_from_link);
  state.box = object.boxes.box(0);
  state.stamp = frame.pose().stamp;
  return state.box ? Trouble::kNone : Trouble::kPoseNotFinite;
}

Trouble LiveObjects::placeOnce(LiveObject& object, const TransformSource& tf, ros::Time now,
                               BoxState& state) {
  if (!object.placement) {
    if (object.trouble == Trouble::kGivenUp) return Trouble::kGivenUp;
    const auto& pose = poseAt(object.content.stamp, object.frame, tf);
    if (!pose) return hasWaitedLong(object, now) ? Trouble::kGivenUp : Trouble::kWaiting;
    object.placement = Placement{target_->fixed_frame, fixed_frame_name_, *pose};
  }
  const std::optional<Eigen::Isometry3d> pose = carried(*object.placement);
  if (!pose) return Trouble::kNotCarried;
  object.boxes.update(0, Eigen::Affine3d(*pose));
  state.box = object.boxes.box(0);
  state.stamp = object.stamp;
  return state.box ? Trouble::kNone : Trouble::kPoseNotFinite;
}

bool LiveObjects::hasWaitedLong(const LiveObject& object, ros::Time now) const {
  const double patience = target_->timeout > 0 ? target_->timeout : kPatience;
  return static_cast<double>(nanoseconds(now) - object.waiting_since) > patience * 1e9;
}

const std::optional<Eigen::Isometry3d>& LiveObjects::poseAt(std::int64_t stamp,
                                                            FollowedFrame::Frame frame,
                                                            const TransformSource& tf) {
  if (!past_pose_ || past_pose_->frame != frame || past_pose_->stamp != stamp) {
    past_pose_ = PastPose{frame, stamp, tf.at(target_->fixed_frame, frame, stamp)};
  }
  return past_pose_->fixed_from_frame;
}

std::vector<const LiveObject*> LiveObjects::takeGivenUp() {
  std::vector<const LiveObject*> result;
  for (const ObjectKey& key : given_up_) {
    const auto found = objects_.find(key);
    if (found == objects_.end()) continue;
    if (found->second.trouble == Trouble::kGivenUp) result.push_back(&found->second);
  }
  given_up_.clear();
  return result;
}

}  // namespace link_bounds
