// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// For stamp 0 a FrameTracker gives the latest poses, as for ~boxes. Other poses come from tf alone.
#include "world/history/past_boxes.h"

#include <ros/time.h>

#include <algorithm>
#include <utility>

#include "text/joined.h"
#include "world/history/pose_gap.h"
#include "world/history/swept_box.h"
#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::hours kNoPause(1000);
constexpr std::size_t kMaxListed = 10;  // names in a message, whose length is limited

std::string shortList(std::vector<std::string> names) {
  const std::size_t count = names.size();
  names.resize(std::min(count, kMaxListed));
  const std::size_t others = count - names.size();
  return quotedList(names) + (others > 0 ? " and " + std::to_string(others) + " more" : "");
}

}  // namespace

PastBoxMaker::PastBoxMaker(PastScene& scene, const BoxRequest& request)
    : scene_(scene), tf_(scene.excerpt.buffer()), request_(request), tracker_(tf_) {
  boxes_.moment.model = scene.model;
  boxes_.moment.header.frame_id = scene.frameName();
  boxes_.moment.header.stamp = timeFrom(request.stamp);
  boxes_.moment.bodies.reserve(scene.bodies.size());
  if (request_.stamp != 0) return;
  tracker_.setTarget(scene_.target, scene_.model->parameters.timeout, scene_.now);
}

bool PastBoxMaker::proceed(std::chrono::nanoseconds budget, const std::function<bool()>& gives_up) {
  const Clock::time_point end = Clock::now() + budget;
  while (made_ < scene_.bodies.size()) {
    makeNext(gives_up);
    if (Clock::now() >= end) break;
  }
  return made_ == scene_.bodies.size();
}

void PastBoxMaker::makeNext(const std::function<bool()>& gives_up) {
  const PastBody& body = scene_.bodies[made_++];
  const auto asks = [&] { return is_given_up_ = is_given_up_ || gives_up(); };
  Made made;
  if (body.frame) made = asks() ? Made{{}, 0, kNotInTime} : make(body, asks);
  boxes_.late += made.problem == kNotInTime;
  if (body.incomplete || !made.problem.empty()) {
    const std::string& name = body.bounded->name;
    const std::string& reason = made.problem.empty() ? body.reason : made.problem;
    if (incomplete_++ == 0) boxes_.problem = name + ": " + reason;
    boxes_.moment.addIncomplete(name, body.link);
  }
  if (made.box) add(body, made);
}

void PastBoxMaker::add(const PastBody& body, const Made& made) {
  Moment& moment = boxes_.moment;
  moment.bodies.push_back({body.link, body.object, made.stamp, *made.box, made.target_from_body});
  if (request_.stamp == 0)
    moment.header.stamp = std::max(moment.header.stamp, timeFrom(made.stamp));
}

PastBoxes PastBoxMaker::take() {
  if (incomplete_ > 1)
    boxes_.problem += "; incomplete are " + std::to_string(incomplete_ - 1) + " more";
  return std::move(boxes_);
}

PastBoxMaker::Made PastBoxMaker::make(const PastBody& body, const std::function<bool()>& gives_up) {
  Pose pose = poseOf(*body.frame);
  if (!pose.target_from_frame) return {{}, 0, std::move(pose.problem)};
  // If the frame does not move, the stamp is that of the transform that placed the body.
  const std::int64_t stamp = pose.stamp == 0 ? body.stamp : pose.stamp;
  Eigen::Affine3d target_from_body = *pose.target_from_frame;
  const bool stays = *body.frame == scene_.target;
  if (body.frame_from_body)
    target_from_body = stays ? *body.frame_from_body : target_from_body * *body.frame_from_body;
  if (request_.span > 0 && pose.stamp != 0) {
    SweptBox swept = sweep(body, pose.stamp, gives_up);
    return {swept.box, swept.box ? stamp : 0, std::move(swept.problem), target_from_body};
  }
  const std::optional<Aabb> box = linkBox(*body.bounded, target_from_body);
  if (box) return {box, stamp, "", target_from_body};
  return {{}, 0, describe(TransformProblem::kPoseNotFinite, nameOf(body), targetName())};
}

PastBoxMaker::Pose PastBoxMaker::poseOf(Frame frame) {
  if (request_.stamp == 0) return latest(frame);
  const auto pose = tf_.pose(scene_.target, frame, request_.stamp);
  if (!pose) return {{}, 0, whyNoPose(scene_.excerpt, scene_.target, frame, request_.stamp)};
  const bool is_static = isStaticPath(tf_, scene_.target, frame);
  return {MatrixPose(*pose).affine, is_static ? 0 : request_.stamp, ""};
}

PastBoxMaker::Pose PastBoxMaker::latest(Frame frame) {
  const FramePose& pose = tracker_.keep(frame);
  if (pose.problem != TransformProblem::kNone)
    return {{}, 0, describe(pose.problem, tf_.name(frame), targetName())};
  return {pose.fixed_from_frame.affine, pose.stamp, ""};
}

SweptBox PastBoxMaker::sweep(const PastBody& body, std::int64_t end,
                             const std::function<bool()>& gives_up) const {
  const MotionSpan span{end - request_.span, end};
  BoundedLink placed;
  if (body.frame_from_body) {
    placed = *body.bounded;
    for (Shape& shape : placed.shapes)
      shape.link_from_shape = *body.frame_from_body * shape.link_from_shape;
  }
  return sweptBox(tf_, scene_.target, *body.frame, span,
                  body.frame_from_body ? placed : *body.bounded, scene_.model->parameters.timeout,
                  gives_up);
}

PastBoxes pastBoxes(PastScene& scene, const BoxRequest& request,
                    const std::function<bool()>& gives_up) {
  PastBoxMaker maker(scene, request);
  maker.proceed(kNoPause, gives_up);
  return maker.take();
}

std::string whyRefused(const PastScene& scene) {
  if (scene.unknown_frame) {
    return "tf has no frame \"" + *scene.unknown_frame +
           "\"; name one that it has, or \"\" for the fixed frame \"" + scene.model->fixed_frame +
           "\"";
  }
  if (scene.unknown_names.empty()) return "";
  return "~boxes has no link and no object with the name " + shortList(scene.unknown_names) +
         "; links without geometry, and those left out by links or ignore_links, have no box";
}

}  // namespace link_bounds
