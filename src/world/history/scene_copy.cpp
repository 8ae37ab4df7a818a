// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies links and objects first, then the transforms from their frames to the request's frame.
#include "world/history/scene_copy.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "link_bounds/robot/urdf/overlap_filter.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kObjectsPerLook = 8;  // copied between two looks at the clock

template <class T>
void sortWithoutRepeats(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

SceneCopy::SceneCopy(BoxRequest request, std::shared_ptr<const Model> model)
    : request_(std::move(request)), model_(std::move(model)) {
  if (request_.frame.empty()) request_.frame = model_->fixed_frame;
  if (request_.names.empty()) {
    links_.resize(model_->links.size());
    std::iota(links_.begin(), links_.end(), 0);
  } else {
    findNames();
  }
  if (request_.has_robot_frames && model_->robot && !model_->attached.empty())
    holders_ = rigidBodies(*model_->robot).of_links;
}

/// Splits the requested names. A name of both a link and an object means the link. The objects are
/// looked up later.
void SceneCopy::findNames() {
  std::unordered_map<std::string_view, std::size_t> links;
  for (std::size_t i = 0; i < model_->links.size(); ++i)
    links.emplace(model_->links[i].name, i);
  sortWithoutRepeats(request_.names);
  for (const std::string& name : request_.names) {
    const auto link = links.find(name);
    const auto key = link == links.end() ? parseObjectName(name) : std::nullopt;
    if (link != links.end()) {
      links_.push_back(link->second);
    } else if (key) {
      keys_.push_back(*key);
    } else {
      unknown_names_.push_back(name);
    }
  }
  sortWithoutRepeats(links_);
  sortWithoutRepeats(keys_);
  unknown_names_.reserve(unknown_names_.size() + keys_.size());
}

bool SceneCopy::proceed(const Scene& scene, ros::Time now, std::chrono::nanoseconds budget) {
  const Clock::time_point end = Clock::now() + budget;
  if (!past_) begin(scene, now);
  observeEpoch(scene.frames.tf(), now);
  if (past_->unknown_frame) return true;
  while (copyNext(scene)) {
    if (Clock::now() >= end) return false;
  }
  return past_->excerpt.copy(scene.frames.tf(), end - Clock::now());
}

/// After a jump of the clock, sets the time of the copy anew, and marks objects that were placed
/// once as outdated. The excerpt begins anew by itself.
void SceneCopy::observeEpoch(const TransformBuffer& tf, ros::Time now) {
  if (epoch_ == tf.epoch()) return;
  epoch_ = tf.epoch();
  past_->now = now;
  past_->excerpt.setStaleBefore(staleBefore(model_->parameters.timeout, now));
  for (PastBody& body : past_->bodies) {
    body.held.reset();
    body.is_outdated |= body.frame_from_body.has_value();
  }
}

void SceneCopy::begin(const Scene& scene, ros::Time now) {
  past_ = std::make_unique<PastScene>(request_, staleBefore(model_->parameters.timeout, now));
  past_->model = model_;
  past_->now = now;
  epoch_ = scene.frames.tf().epoch();
  past_->unknown_names = std::move(unknown_names_);
  const std::size_t objects = scene.objects.objects().size();
  const std::size_t bodies =
      links_.size() + (request_.names.empty() ? objects : std::min(keys_.size(), objects));
  past_->bodies.reserve(bodies);
  past_->excerpt.reserve(bodies + 1);
  const TransformBuffer& tf = scene.frames.tf();
  const auto target = tf.find(request_.frame);
  if (target && (tf.isMet(*target) || request_.frame == model_->fixed_frame)) {
    past_->target = past_->excerpt.add(tf, *target);
  } else {
    past_->unknown_frame = request_.frame;
  }
}

/// Copies the next bodies, or the next frame of the robot. False if nothing is left.
bool SceneCopy::copyNext(const Scene& scene) {
  if (copyNextBody(scene)) return true;
  if (!request_.has_robot_frames || !model_->robot) return false;
  const std::vector<Link>& links = model_->robot->links;
  if (next_frame_ == links.size()) return false;
  copyFrame(scene, links[next_frame_++]);
  return true;
}

void SceneCopy::copyFrame(const Scene& scene, const Link& link) {
  const TransformBuffer& tf = scene.frames.tf();
  const std::string name = tfName(model_->parameters.tf_prefix, link.name);
  const auto frame = tf.find(name);
  const bool is_known = frame && (tf.isMet(*frame) || name == model_->fixed_frame);
  past_->robot_frames.push_back(is_known ? std::make_optional(past_->excerpt.add(tf, *frame))
                                         : std::nullopt);
}

bool SceneCopy::copyNextBody(const Scene& scene) {
  if (next_link_ < links_.size()) {
    copyLink(scene, links_[next_link_++]);
    return true;
  }
  const LiveObjects::Objects& objects = scene.objects.objects();
  if (request_.names.empty()) {
    auto next = last_object_ ? objects.upper_bound(*last_object_) : objects.begin();
    if (next == objects.end()) return false;
    auto last = next;
    for (int i = 0; i < kObjectsPerLook && next != objects.end(); ++i) {
      copyObject(scene, next->second);
      last = next++;
    }
    last_object_ = last->first;
    return true;
  }
  if (next_key_ == keys_.size()) return false;
  const ObjectKey& key = keys_[next_key_++];
  const auto [begin, end] = scene.objects.named(key);
  if (begin == end) past_->unknown_names.push_back(objectName(key));
  for (auto object = begin; object != end; ++object)
    copyObject(scene, object->second);
  return true;
}

void SceneCopy::copyLink(const Scene& scene, std::size_t link) {
  const TransformBuffer& tf = scene.frames.tf();
  PastBody body;
  body.bounded = &model_->links[link];
  body.link = link;
  body.incomplete = !body.bounded->isWhole();
  body.reason = body.bounded->missing;
  // After a ~reload, model_ may differ from the model of the scene.
  const auto frame =
      scene.links.model() == model_.get() ? scene.links.frame(link) : tf.find(model_->frames[link]);
  if (frame && !body.bounded->shapes.empty()) body.frame = past_->excerpt.add(tf, *frame);
  past_->bodies.push_back(std::move(body));
}

/// An object that follows its frame moves with it, and so does a neighbour's box if
/// isNeighbourElsewhere(). All other objects stay at their last box.
void SceneCopy::copyObject(const Scene& scene, const LiveObject& object) {
  const TransformBuffer& tf = scene.frames.tf();
  PastBody body;
  body.object = object.content;
  const bool follows = object.content->follows() && object.content->stamp == 0;
  if (isNeighbourElsewhere(scene, object)) {
    body.incomplete = object.state.incomplete;
    body.reason = scene.objects.reason(object);
    body.frame = past_->excerpt.add(tf, object.frame);
    body.stamp = object.state.stamp;
  } else if (follows && object.content->refused_name.empty() && object.content->bounded.isWhole() &&
             !object.content->isLoading()) {
    body.frame = past_->excerpt.add(tf, object.frame);
  } else {
    body.incomplete = object.state.incomplete;
    body.reason = scene.objects.reason(object);
    const bool has_header = follows || (object.content->follows() && !object.state.box);
    if (has_header && request_.has_robot_frames) body.header = past_->excerpt.add(tf, object.frame);
    if (object.state.box) {
      body.object = object.boxed.content;
      body.frame = past_->excerpt.add(tf, *scene.frames.fixedFrame());
      body.frame_from_body = object.boxed.fixed_from_header;
      body.stamp = object.state.stamp;
      body.is_carried_over =
          object.placement && object.placement->fixed_frame != scene.frames.fixedFrame();
      body.is_outdated = object.stamp_time != StampTime::kKnown;
      if (!body.is_outdated && isHeldSince(scene, object)) body.held = heldPlace(scene, body);
    }
  }
  body.bounded = &body.object->bounded;
  past_->bodies.push_back(std::move(body));
}

/// Whether the object is a neighbour's box that moves with its frame, which is not the fixed frame:
/// see BoxRequest::neighbours_follow. A box that is attached to a link instead moves with that link
/// if its own frame is at rest.
bool SceneCopy::isNeighbourElsewhere(const Scene& scene, const LiveObject& object) const {
  const ObjectContent& content = *object.content;
  if (!request_.neighbours_follow || !content.is_neighbour || content.stamp == 0 ||
      !object.state.box || object.boxed.content != object.content ||
      object.frame == *scene.frames.fixedFrame())
    return false;
  return object.header.pose().stamp != 0 || !bodyOf(*model_, {&content.bounded.name, std::nullopt});
}

/// Whether the object's place in the fixed frame is of the time of its stamp, so that heldPlace()
/// may compare it with the link at that stamp. After a change of the fixed frame it is of a later
/// time.
bool SceneCopy::isHeldSince(const Scene& scene, const LiveObject& object) const {
  if (holders_.empty() || object.state.stamp == 0) return false;
  if (object.state.stamp != object.boxed.content->stamp) return false;
  if (object.placement) return object.placement->fixed_frame == scene.frames.fixedFrame();
  // A neighbour's box follows its frame, so its place is of its stamp only if that frame is at
  // rest.
  return object.content->is_neighbour && object.header.pose().stamp == 0;
}

std::optional<HeldPlace> SceneCopy::heldPlace(const Scene& scene, const PastBody& body) const {
  const TransformBuffer& tf = scene.frames.tf();
  const auto attached = bodyOf(*model_, {&body.object->bounded.name, std::nullopt});
  const auto holder =
      attached ? std::find(holders_.begin(), holders_.end(), *attached) : holders_.end();
  if (holder == holders_.end()) return std::nullopt;
  const auto link = static_cast<std::size_t>(holder - holders_.begin());
  const auto frame = tf.find(tfName(model_->parameters.tf_prefix, model_->robot->links[link].name));
  const auto pose = frame ? tf.pose(*frame, *scene.frames.fixedFrame(), body.stamp) : std::nullopt;
  if (!pose) return std::nullopt;
  return HeldPlace{link, MatrixPose(*pose).affine * *body.frame_from_body};
}

}  // namespace link_bounds
