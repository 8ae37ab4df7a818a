// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses of the latest time come from a FrameTracker, as those of ~boxes; all others from tf alone.
#include "node/history/past_boxes.h"

#include <ros/time.h>

#include <algorithm>
#include <utility>

#include "node/history/pose_gap.h"
#include "node/history/swept_box.h"
#include "node/loading/model.h"
#include "node/tf/frame_tracker.h"

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;

/// A box, or why there is none.
struct PastBox {
  std::optional<Aabb> box;
  std::int64_t stamp = 0;
  std::string problem;
};

/// The pose of a frame in that of the request.
struct PastPose {
  std::optional<Eigen::Affine3d> target_from_frame;
  std::int64_t stamp = 0;  ///< 0: all its transforms are static
  std::string problem;     ///< if there is no pose
};

class PastBoxMaker {
 public:
  PastBoxMaker(PastScene& scene, const BoxRequest& request)
      : scene_(scene), tf_(scene.excerpt.buffer()), request_(request), tracker_(tf_) {
    if (request_.stamp != 0) return;
    tracker_.setTarget(scene_.target, scene_.model->parameters.timeout, scene_.now);
  }

  PastBox make(const PastBody& body) {
    PastPose pose = poseOf(*body.frame);
    if (!pose.target_from_frame) return {{}, 0, std::move(pose.problem)};
    // A body that stays in a frame that does not move is where its own transform placed it.
    const std::int64_t stamp = pose.stamp == 0 ? body.stamp : pose.stamp;
    if (request_.span > 0 && pose.stamp != 0) return sweep(body, pose.stamp, stamp);
    Eigen::Affine3d target_from_body = *pose.target_from_frame;
    const bool stays = *body.frame == scene_.target;
    if (body.frame_from_body)
      target_from_body = stays ? *body.frame_from_body : target_from_body * *body.frame_from_body;
    const std::optional<Aabb> box = linkBox(*body.bounded, target_from_body);
    if (box) return {box, stamp, ""};
    return {{}, 0, describe(TransformProblem::kPoseNotFinite, nameOf(body), targetName())};
  }

 private:
  const std::string& targetName() const { return tf_.name(scene_.target); }
  const std::string& nameOf(const PastBody& body) const { return tf_.name(*body.frame); }

  PastPose poseOf(Frame frame) {
    if (request_.stamp == 0) return latest(frame);
    const auto pose = tf_.pose(scene_.target, frame, request_.stamp);
    if (!pose) return {{}, 0, whyNoPose(scene_.excerpt, scene_.target, frame, request_.stamp)};
    const bool is_static = isStaticPath(tf_, scene_.target, frame);
    return {MatrixPose(*pose).affine, is_static ? 0 : request_.stamp, ""};
  }

  PastPose latest(Frame frame) {
    handles_.push_back(tracker_.follow(frame));
    const FramePose& pose = handles_.back().pose();
    if (pose.problem != TransformProblem::kNone)
      return {{}, 0, describe(pose.problem, tf_.name(frame), targetName())};
    return {pose.fixed_from_frame.affine, pose.stamp, ""};
  }

  PastBox sweep(const PastBody& body, std::int64_t end, std::int64_t stamp) const {
    const MotionSpan span{end - request_.span, end};
    BoundedLink placed;
    if (body.frame_from_body) {
      placed = *body.bounded;
      for (Shape& shape : placed.shapes)
        shape.link_from_shape = *body.frame_from_body * shape.link_from_shape;
    }
    SweptBox swept =
        sweptBox(tf_, scene_.target, *body.frame, span,
                 body.frame_from_body ? placed : *body.bounded, scene_.model->parameters.timeout);
    return {swept.box, swept.box ? stamp : 0, std::move(swept.problem)};
  }

  PastScene& scene_;
  TransformBuffer& tf_;
  const BoxRequest& request_;
  FrameTracker tracker_;
  std::vector<FrameTracker::Handle> handles_;  ///< after the tracker, so that they end before it
};

/// One line for all that is incomplete: the first one without a box, or else the first one.
class ProblemText {
 public:
  void add(const std::string& name, const std::string& reason, bool has_box) {
    ++count_;
    if (count_ > 1 && (has_box || !has_box_)) return;
    has_box_ = has_box;
    text_ = name + ": " + reason;
  }

  std::string text() const {
    if (count_ < 2) return text_;
    return text_ + "; incomplete are " + std::to_string(count_ - 1) + " more";
  }

 private:
  std::size_t count_ = 0;
  bool has_box_ = false;
  std::string text_;
};

std::string quotedList(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "\"" : ", \"") + name + "\"";
  return text;
}

}  // namespace

PastBoxes pastBoxes(PastScene& scene, const BoxRequest& request,
                    const std::function<bool()>& is_cancelled) {
  PastBoxMaker maker(scene, request);
  PastBoxes result;
  ProblemText problem;
  result.entries.reserve(scene.bodies.size());
  for (const PastBody& body : scene.bodies) {
    if (is_cancelled()) break;
    PastBox made;
    if (body.frame) made = maker.make(body);
    BoxState state{made.box, made.stamp, body.incomplete || !made.problem.empty()};
    const std::string& name = body.bounded->name;
    if (state.incomplete)
      problem.add(name, made.problem.empty() ? body.reason : made.problem, state.box.has_value());
    result.entries.push_back({&name, std::move(state)});
  }
  result.problem = problem.text();
  return result;
}

std::string whyRefused(const PastScene& scene) {
  if (scene.unknown_frame) {
    return "tf has no frame \"" + *scene.unknown_frame +
           "\"; name one that it has, or \"\" for the fixed frame \"" + scene.model->fixed_frame +
           "\"";
  }
  if (scene.unknown_names.empty()) return "";
  return "~boxes has no link and no object with the name " + quotedList(scene.unknown_names) +
         "; links without geometry, and those left out by links or ignore_links, have no box";
}

}  // namespace link_bounds
