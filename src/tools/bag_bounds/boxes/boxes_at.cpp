// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/boxes/boxes_at.h"

#include "world/history/pose_gap.h"

namespace link_bounds {

void BoxesAt::look(const Scene& scene, const TransformBuffer& tf, std::int64_t now) {
  // After that time, tf has forgotten the poses at the stamp.
  if (!has_begun_ || missing_ == 0 || now - stamp_ > EdgeHistory::kLength) return;
  const TransformBuffer::Frame fixed = *scene.frames.fixedFrame();
  for (Body& body : bodies_) {
    if (body.box) continue;
    const std::optional<TransformBuffer::Frame> frame = tf.find(body.frame);
    const auto pose = frame ? tf.pose(fixed, *frame, body.at) : std::nullopt;
    if (!pose) continue;
    body.box = linkBox(*body.link, MatrixPose(*pose).affine * body.frame_from_body);
    body.stamp = isStaticPath(tf, fixed, *frame) ? 0 : body.at;
    if (body.box) --missing_;
  }
}

void BoxesAt::begin(const Scene& scene, const TransformBuffer& tf) {
  has_begun_ = true;
  scene.forEach([&](const SceneBody& body) {
    const bool waits = body.object && body.object->problem == TransformProblem::kWaiting;
    // Before its stamp, it is still where its former marker placed it.
    const bool stands = waits && body.state.box && body.object->stamp > stamp_;
    if (waits && !stands && body.object->content->isBounded()) {
      const auto& content = body.object->content;
      bodies_.push_back({body.name, &content->bounded, content, content->frame,
                         Eigen::Affine3d::Identity(), body.object->stamp, std::nullopt, 0});
      return;
    }
    if (body.object && !body.state.box) {
      boxless_.push_back({body.name, std::nullopt, 0, noBox() + scene.reason(body)});
      return;
    }
    const BoxSource source = scene.boxSource(body);
    if (source.bounded.shapes.empty()) return;
    bodies_.push_back(
        {body.name, &source.bounded, source.object, scene.frames.tf().name(source.frame),
         source.frame_from_body ? *source.frame_from_body : Eigen::Affine3d::Identity(), stamp_,
         std::nullopt, 0});
  });
  missing_ = bodies_.size();
  look(scene, tf, stamp_);
}

std::string BoxesAt::noBox() const {
  return "no box at " + secondsText(stamp_) + ": ";
}

std::vector<BoxAt> BoxesAt::boxes(const Scene& scene) const {
  if (!has_begun_) return {{"--at", std::nullopt, 0, "the report ends before that time"}};
  std::vector<BoxAt> result;
  for (const Body& body : bodies_) {
    std::string problem;
    if (!body.box)
      problem =
          noBox() + "tf does not connect it with " + scene.model()->fixed_frame + " at that time";
    result.push_back({body.name, body.box, body.stamp, problem});
  }
  result.insert(result.end(), boxless_.begin(), boxless_.end());
  return result;
}

}  // namespace link_bounds
