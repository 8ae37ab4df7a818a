// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bag_bounds/body_motions.h"

#include "world/history/swept_box.h"

namespace link_bounds {

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
      target_(view ? view->frame() : *scene.frames.fixedFrame()),
      fixed_frame_(*scene.frames.fixedFrame()),
      timeout_(static_cast<std::int64_t>(scene.model()->parameters.timeout * 1e9)),
      last_number_(scene.model()->links.size()) {
  for (const BoundedLink& link : scene.model()->links)
    radii_.push_back(radiusOf(link));
}

/// In the scene's own frame an object that was placed once stands.
FrameView::Placed BodyMotions::placedInScene(const LiveObject& object) const {
  const bool follows = object.state.box && object.boxed.content->follows() && object.header;
  return {object.state, follows ? object.header.pose().stamp : 0};
}

const BodyMotion* BodyMotions::next(Last& last, const BoxState& state, const Content& content) {
  const bool is_same = last.has_box && state.box && last.object.get() == content.object;
  const std::int64_t passed = content.stamp - last.stamp;
  const bool has_moved =
      is_same && last.stamp != 0 && passed > 0 && (timeout_ == 0 || passed <= timeout_);
  if (has_moved) {
    motion_ = {{last.stamp, content.stamp}, last.box, 0, target_, content.source, content.link,
               content.source_from_link};
    const double radius =
        content.object
            ? radiusOf(motion_)
            : radii_[static_cast<std::size_t>(content.link - scene_.model()->links.data())];
    motion_.way = ways_.of(content.source, radius, motion_.span);
  }
  last.has_box = state.box.has_value();
  last.stamp = content.stamp;
  if (state.box) last.box = *state.box;
  return has_moved ? &motion_ : nullptr;
}

void BodyMotions::forgetObjects() {
  if (last_objects_.size() == scene_.objects.objects().size()) return;
  for (auto last = last_objects_.begin(); last != last_objects_.end();)
    last = last->second.seen == pass_ ? std::next(last) : last_objects_.erase(last);
}

}  // namespace link_bounds
