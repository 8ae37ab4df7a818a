// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/boxes_at.h"

#include "world/history/pose_gap.h"

namespace link_bounds {

void BoxesAt::look(const Scene& scene, const TransformBuffer& tf, std::int64_t now) {
  // Later tf has forgotten it.
  if (now < stamp_ || now - stamp_ > EdgeHistory::kLength) return;
  if (!has_begun_) begin(scene);
  if (missing_ == 0) return;
  const TransformBuffer::Frame fixed = *scene.frames.fixedFrame();
  for (Body& body : bodies_) {
    if (body.box) continue;
    const std::optional<Tf2Pose> pose = tf.pose(fixed, body.frame, stamp_);
    if (!pose) continue;
    body.box = linkBox(*body.link, MatrixPose(*pose).affine * body.frame_from_body);
    body.stamp = isStaticPath(tf, fixed, body.frame) ? 0 : stamp_;
    if (body.box) --missing_;
  }
}

void BoxesAt::begin(const Scene& scene) {
  has_begun_ = true;
  const std::vector<BoundedLink>& links = scene.model()->links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!links[i].shapes.empty())
      bodies_.push_back({links[i].name, &links[i], nullptr, scene.links.frame(i),
                         Eigen::Affine3d::Identity(), std::nullopt, 0});
  }
  for (const auto& [key, object] : scene.objects.objects()) {
    if (!object.state.box) continue;
    const auto& content = object.boxed.content;
    const bool follows = content->follows();
    bodies_.push_back({content->bounded.name, &content->bounded, content,
                       follows ? object.frame : *scene.frames.fixedFrame(),
                       follows ? Eigen::Affine3d::Identity() : object.boxed.fixed_from_header,
                       std::nullopt, 0});
  }
  missing_ = bodies_.size();
}

std::vector<BoxAt> BoxesAt::boxes(const Scene& scene) const {
  if (!has_begun_) return {{"--at", std::nullopt, 0, "the report ends before that time"}};
  std::vector<BoxAt> result;
  for (const Body& body : bodies_) {
    std::string problem;
    if (!body.box)
      problem = "no box at " + secondsText(stamp_) + ": tf does not connect it with " +
                scene.model()->fixed_frame + " at that time";
    result.push_back({body.name, body.box, body.stamp, problem});
  }
  return result;
}

}  // namespace link_bounds
