// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Recomputes the box of an object if its content, the pose of its frame, or its age changed.
#include "world/bodies/live_objects.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace link_bounds {

std::pair<LiveObjects::Objects::const_iterator, LiveObjects::Objects::const_iterator>
LiveObjects::named(const ObjectKey& key) const {
  ObjectKey end = key;
  end.set = std::numeric_limits<std::uint64_t>::max();
  return {objects_.lower_bound({key.ns, key.id, key.name}), objects_.upper_bound(end)};
}

const LiveObject* LiveObjects::otherOfName(const ObjectKey& key) const {
  const auto [begin, end] = named(key);
  for (auto object = begin; object != end; ++object) {
    if (object->first.set != key.set && object->second.content->refused_name.empty())
      return &object->second;
  }
  return nullptr;
}

void LiveObjects::adopt(ros::Time now) {
  const FrameTracker::Frame fixed_frame = *frames_.fixedFrame();
  if (fixed_frame_ && *fixed_frame_ != fixed_frame) leaveFixedFrame();
  fixed_frame_ = fixed_frame;
  const std::int64_t start = clock_.observe(now);
  removeIf(
      [&](const auto& entry) { return entry.second.is_silent || isSilent(entry.second, start); });
  for (auto& [key, object] : objects_)
    object.waiting_since = object.unplaced_since = start;
  refreshAll(now);
}

/// Drops all boxes in the old fixed frame.
void LiveObjects::leaveFixedFrame() {
  std::vector<FrameTracker::Frame> placed_in;
  for (auto& [key, object] : objects_) {
    object.state.box.reset();
    if (object.problem == TransformProblem::kGivenUp) object.problem = TransformProblem::kNone;
    if (object.placement) placed_in.push_back(object.placement->fixed_frame);
  }
  placer_.carryFrom(placed_in);
}

bool LiveObjects::put(const ObjectKey& key, ObjectContent content, ros::Time now) {
  const auto [entry, is_new] = objects_.try_emplace(key);
  LiveObject& object = entry->second;
  object.received = clock_.observe(now);
  object.waiting_since = object.received;
  object.lifetime = content.lifetime;
  object.sender = content.publisher;
  object.is_silent = object.was_static = false;
  if (object.problem != TransformProblem::kWaiting) object.unplaced_since = object.received;
  const bool was_given_up = object.problem == TransformProblem::kGivenUp;
  const bool is_same = !is_new && isSame(*object.content, content);
  if (is_same && !was_given_up) return sendAgain(object, now);
  const bool had_stamp =
      !is_new && object.content->stamp == content.stamp && object.stamp_time != StampTime::kKnown;
  if (!is_new) release(object);
  object.content = std::make_shared<const ObjectContent>(std::move(content));
  object.boxes = LinkBoxes({object.content->bounded});
  object.problem = TransformProblem::kNone;
  object.stamp = clock_.stampOf(*object.content, object.received);
  object.placement.reset();
  object.stamp_time = stampTime(object, had_stamp);
  follow(object);
  return refresh(object, now) || is_new;
}

/// Handles an object that is sent again with the same content. It may have been sent before the
/// clock jumped back. If it is placed anew or waits for that, its content counts as new: it was not
/// at that place before.
bool LiveObjects::sendAgain(LiveObject& object, ros::Time now) {
  if (object.stamp_time > StampTime::kOutside) return false;
  const StampTime stamp_time = stampTime(object, true);
  if (stamp_time == StampTime::kOutside) return false;
  object.stamp_time = stamp_time;
  if (!object.placement) {
    object.stamp = object.content->stamp;
    return refresh(object, now);
  }
  object.placement->is_earlier = true;
  const auto before = object.content;
  object.content = std::make_shared<const ObjectContent>(*before);
  const bool is_changed = refresh(object, now);
  if (object.stamp_time == StampTime::kNotSent) {  // it was not placed anew
    if (object.boxed.content == object.content) object.boxed.content = before;
    object.content = before;
  }
  return is_changed;
}

/// The value on receipt. `had_stamp`: the object existed with the same stamp and was not kKnown.
StampTime LiveObjects::stampTime(const LiveObject& object, bool had_stamp) const {
  const bool may_be_old = has_jumped_back_ || had_stamp;
  if (object.content->stamp == 0 || !may_be_old) return StampTime::kKnown;
  if (!clock_.isSinceJump(*object.content, object.received)) return StampTime::kOutside;
  return has_jumped_back_ && had_stamp ? StampTime::kRepeated : StampTime::kKnown;
}

const LiveObject* LiveObjects::firstWithMesh(const std::string& uri) const {
  const auto users = mesh_users_.find(uri);
  if (users == mesh_users_.end()) return nullptr;
  const auto name = [](const LiveObject* user) { return user->content->bounded.name; };
  return *std::min_element(users->second.begin(), users->second.end(),
                           [&](auto* a, auto* b) { return name(a) < name(b); });
}

bool LiveObjects::endStatic(const ObjectKey& key, ros::Time now) {
  const auto found = objects_.find(key);
  if (found == objects_.end() || !found->second.content->is_static) return false;
  LiveObject& object = found->second;
  auto content = std::make_shared<ObjectContent>(*object.content);
  content->is_static = false;
  object.was_static = true;
  object.content = std::move(content);
  object.received = clock_.observe(now);
  return refresh(object, now);
}

bool LiveObjects::remove(const ObjectKey& key) {
  const auto found = objects_.find(key);
  if (found == objects_.end()) return false;
  erase(found);
  return true;
}

bool LiveObjects::removeAll() {
  return removeIf([](const auto& entry) { return !entry.second.content->is_neighbour; });
}

bool LiveObjects::removeAllOf(const std::string& publisher) {
  return removeIf([&publisher](const auto& entry) {
    return !entry.second.content->is_neighbour && entry.second.sender == publisher;
  });
}

bool LiveObjects::removeIf(const std::function<bool(const Objects::value_type&)>& is_over) {
  const std::size_t count = objects_.size();
  for (auto entry = objects_.begin(); entry != objects_.end();)
    entry = is_over(*entry) ? erase(entry) : std::next(entry);
  return objects_.size() != count;
}

void LiveObjects::follow(LiveObject& object) {
  object.hold = TransformBuffer::Hold();
  if (!object.content->mesh_uri.empty()) mesh_users_[object.content->mesh_uri].insert(&object);
  if (object.content->frame.empty()) return;
  object.hold = TransformBuffer::Hold(frames_.tf(), object.content->frame);
  object.frame = object.hold.frame();
  if (!object.content->follows()) {
    if (needs_places_) object.needed = frames_.follow(object.frame);
    return;
  }
  object.header = frames_.follow(object.frame);
  followers_[object.frame].insert(&object);
}

/// Undoes follow(), and what refresh() counted.
void LiveObjects::release(LiveObject& object) {
  if (object.problem == TransformProblem::kWaiting) --waiting_;
  object.needed = FrameTracker::Handle();
  if (!object.content->mesh_uri.empty()) erase(object.content->mesh_uri, object, mesh_users_);
  if (!object.header) return;
  object.header = FrameTracker::Handle();
  erase(object.frame, object, followers_);
}

template <class Key>
void LiveObjects::erase(const Key& key, LiveObject& object,
                        std::map<Key, std::set<LiveObject*>>& sets) {
  const auto set = sets.find(key);
  set->second.erase(&object);
  if (set->second.empty()) sets.erase(set);
}

LiveObjects::Objects::iterator LiveObjects::erase(Objects::iterator object) {
  release(object->second);
  ++removals_;
  return objects_.erase(object);
}

bool LiveObjects::fillMesh(const std::string& uri, const LoadedMesh& mesh, ros::Time now) {
  const auto users = mesh_users_.find(uri);
  if (users == mesh_users_.end()) return false;
  bool is_changed = false;
  for (LiveObject* user : users->second) {
    LiveObject& object = *user;
    const BoundedLink& before = object.content->bounded;
    auto content = std::make_shared<ObjectContent>(*object.content);
    content->setMesh(mesh);
    if (content->bounded.shapes.front().points == before.shapes.front().points &&
        content->bounded.missing == before.missing)
      continue;
    object.content = std::move(content);
    object.boxes = LinkBoxes({object.content->bounded});
    is_changed |= refresh(object, now);
  }
  return is_changed;
}

bool LiveObjects::update(ros::Time now) {
  clock_.observe(now);
  if (!fixed_frame_) return false;
  bool is_changed = placer_.findCarries() && refreshNotCarried(now);
  is_changed |= refreshWaiting(now);
  is_changed |= refreshFollowing(now);
  return is_changed;
}

bool LiveObjects::restart(ros::Time now) {
  has_jumped_back_ = true;
  for (auto& [key, object] : objects_) {
    if (object.content->stamp != 0) object.stamp_time = StampTime::kNotSent;
  }
  return startClock(now);
}

bool LiveObjects::startClock(ros::Time now) {
  bool is_changed = false;
  for (auto& [key, object] : objects_)
    object.received = clock_.receivedAfterJump(object, now);
  const std::int64_t start = clock_.restart(now);
  for (auto& [key, object] : objects_) {
    object.waiting_since = object.unplaced_since = start;
    if (object.stamp > start) object.stamp_time = std::min(object.stamp_time, StampTime::kOutside);
    object.stamp = std::min(object.stamp, start);
    is_changed |= object.state.stamp > start;
    object.state.stamp = std::min(object.state.stamp, start);
  }
  is_changed |= refreshAll(now);
  return is_changed;
}

bool LiveObjects::expire(ros::Time now) {
  const std::int64_t time = clock_.observe(now);
  bool is_changed = removeIf([&](const auto& entry) {
    const LiveObject& object = entry.second;
    return hasExpired(object, time) ||
           (object.is_silent && !object.was_static && isSilent(object, time, kForget));
  });
  if (!fixed_frame_) return is_changed;
  for (auto& [key, object] : objects_) {
    if (!object.is_silent && isSilent(object, time)) is_changed |= dropSilent(object, now);
    if (!object.content->refused_name.empty()) is_changed |= nameAgain(key, object, now);
  }
  is_changed |= refreshWaiting(now);
  is_changed |= refreshFollowing(now);
  return is_changed;
}

/// Whether a neighbour sent nothing for `timeouts` timeouts. A static box never is silent.
bool LiveObjects::isSilent(const LiveObject& object, std::int64_t now, double timeouts) const {
  const ObjectContent& content = *object.content;
  return content.is_neighbour && !content.is_static && frames_.timeout() > 0 &&
         static_cast<double>(now - object.received) > timeouts * frames_.timeout() * 1e9;
}

/// Removes the box. Restarts the time until the neighbour is forgotten, because the clock may have
/// jumped ahead.
bool LiveObjects::dropSilent(LiveObject& object, ros::Time now) {
  object.is_silent = true;
  object.received = clock_.observe(now) - static_cast<std::int64_t>(frames_.timeout() * 1e9);
  if (object.content->bounded.shapes.empty()) return false;
  auto content = std::make_shared<ObjectContent>(*object.content);
  content->bounded.shapes.clear();
  content->bounded.missing = content->publisher + " has sent no boxes for longer than timeout";
  object.content = std::move(content);
  object.boxes = LinkBoxes({object.content->bounded});
  return refresh(object, now);
}

/// Gives a marker its box once its name is free. A refused neighbour gets its box when it is sent
/// again.
bool LiveObjects::nameAgain(const ObjectKey& key, LiveObject& object, ros::Time now) {
  if (object.content->is_neighbour || otherOfName(key)) return false;
  auto content = std::make_shared<ObjectContent>(*object.content);
  content->refused_name.clear();
  object.content = std::move(content);
  return refresh(object, now);
}

/// A new pose counts as a change even if the box comes out the same.
bool LiveObjects::refreshFollowing(ros::Time now) {
  bool is_changed = false;
  for (const auto& [frame, objects] : followers_) {
    if (!(*objects.begin())->header.pose().is_changed) continue;
    for (LiveObject* object : objects)
      is_changed |= refresh(*object, now) || !object->state.incomplete;
  }
  return is_changed;
}

bool LiveObjects::refreshNotCarried(ros::Time now) {
  bool is_changed = false;
  for (auto& [key, object] : objects_) {
    if (object.problem == TransformProblem::kNotCarried) is_changed |= refresh(object, now);
  }
  return is_changed;
}

bool LiveObjects::refreshWaiting(ros::Time now) {
  if (waiting_ == 0) return false;
  bool is_changed = false;
  for (auto& [key, object] : objects_) {
    if (object.problem != TransformProblem::kWaiting) continue;
    is_changed |= refresh(object, now);
    if (object.problem == TransformProblem::kGivenUp) given_up_.push_back(key);
  }
  return is_changed;
}

bool LiveObjects::refreshAll(ros::Time now) {
  if (!fixed_frame_) return false;
  placer_.findCarries();
  bool is_changed = false;
  for (auto& [key, object] : objects_)
    is_changed |= refresh(object, now);
  return is_changed;
}

/// A new body counts as a change even if its box is the same, because distances depend on bodies.
bool LiveObjects::refresh(LiveObject& object, ros::Time now) {
  if (object.problem == TransformProblem::kWaiting) --waiting_;
  BoxState state;
  const std::shared_ptr<const ObjectContent> boxed = object.boxed.content;
  const TransformProblem before = std::exchange(object.problem, bound(object, now, state));
  if (object.problem == TransformProblem::kWaiting) ++waiting_;
  const bool is_loading = object.content->isLoading();
  const bool has_name = object.content->refused_name.empty();
  const bool waits = object.problem == TransformProblem::kWaiting || is_loading;
  if (waits && !state.box) state = object.state;
  if (!has_name) state.box.reset();
  state.incomplete = object.problem != TransformProblem::kNone || is_loading || !has_name ||
                     !object.content->bounded.isWhole();
  if (!state.box) object.boxed = BoxedObject();
  const auto is_other = [&] {  // last in the condition: compares all points of a list
    return boxed && state.box && boxed != object.boxed.content &&
           !isSameBody(*boxed, *object.boxed.content);
  };
  const bool is_changed = before != object.problem || !isSame(state, object.state) || is_other();
  object.state = state;
  return is_changed;
}

TransformProblem LiveObjects::bound(LiveObject& object, ros::Time now, BoxState& state) {
  if (!fixed_frame_) return TransformProblem::kNoTransform;
  if (!object.content->isBounded()) return TransformProblem::kNone;
  const ObjectPose pose = placer_.place(object, now);
  const bool waits = pose.problem == TransformProblem::kWaiting;
  if (!pose.fixed_from_header || (waits && object.state.box)) return pose.problem;
  object.boxes.update(0, *pose.fixed_from_header);
  state.box = object.boxes.box(0);
  if (state.box) object.boxed = {object.content, *pose.fixed_from_header};
  state.stamp = pose.stamp;
  return state.box || waits ? pose.problem : TransformProblem::kPoseNotFinite;
}

std::vector<const LiveObject*> LiveObjects::takeGivenUp() {
  std::vector<const LiveObject*> result;
  for (const ObjectKey& key : given_up_) {
    const auto found = objects_.find(key);
    if (found == objects_.end()) continue;
    if (found->second.problem == TransformProblem::kGivenUp) result.push_back(&found->second);
  }
  given_up_.clear();
  return result;
}

std::vector<LiveObjects::NeverPlaced> LiveObjects::neverPlaced(ros::Time now) {
  std::vector<NeverPlaced> result;
  if (waiting_ == 0) return result;
  for (const auto& [key, object] : objects_) {
    if (object.problem != TransformProblem::kWaiting) continue;
    if (!placer_.hasWaitedLong(object.unplaced_since, now)) continue;
    const FrameTracker::Handle header = frames_.follow(object.frame);
    const std::int64_t ahead = object.content->stamp - header.pose().stamp;
    if (header.pose().problem == TransformProblem::kNone)
      result.push_back({&object, static_cast<double>(ahead) * 1e-9});
  }
  return result;
}

const std::string& LiveObjects::neededFrame(const LiveObject& object) const {
  if (object.problem != TransformProblem::kNotCarried) return object.content->frame;
  return frames_.tf().name(object.placement->fixed_frame);
}

std::string LiveObjects::reason(const LiveObject& object) const {
  const ObjectContent& content = *object.content;
  if (!content.refused_name.empty()) return content.refused_name;
  if (!content.bounded.isWhole()) return content.bounded.missing;
  if (content.isLoading()) return "its mesh " + content.mesh_uri + " is still loading";
  if (!fixed_frame_) return "there is no fixed frame yet";
  return describe(object.problem, neededFrame(object), frames_.tf().name(*fixed_frame_));
}

}  // namespace link_bounds
