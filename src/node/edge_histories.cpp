// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Climbs from the source as far as it goes, then from the target until it meets that way.
#include "edge_histories.h"

#include <algorithm>

namespace link_bounds {
namespace {

Tf2Pose operator*(const Tf2Pose& a, const Tf2Pose& b) {
  return {a.rotation * b.rotation, tf2::quatRotate(a.rotation, b.translation) + a.translation};
}

Tf2Pose inverse(const Tf2Pose& pose) {
  const tf2::Quaternion rotation = pose.rotation.inverse();
  return {rotation, tf2::quatRotate(rotation, -pose.translation)};
}

/// tf2 keeps 0 for "no frame".
tf2::CompactFrameID toId(FrameTree::Frame frame) {
  return static_cast<tf2::CompactFrameID>(frame + 1);
}

FrameTree::Frame toFrame(tf2::CompactFrameID id) {
  return id - 1;
}

}  // namespace

bool EdgeHistories::insert(const geometry_msgs::TransformStamped& transform, Frame child,
                           Frame parent, bool is_static) {
  caches_.resize(std::max({caches_.size(), child + 1, parent + 1}));
  auto& cache = caches_[child];
  if (!cache && is_static) cache = std::make_shared<tf2::StaticCache>();
  if (!cache) cache = std::make_shared<tf2::TimeCache>();
  return cache->insertData(tf2::TransformStorage(transform, toId(parent), toId(child)));
}

void EdgeHistories::clear() {
  for (auto& cache : caches_) {
    if (cache) cache->clearList();
  }
}

void EdgeHistories::clear(Frame child) {
  caches_[child]->clearList();
}

bool EdgeHistories::read(Frame child, ros::Time time, Tf2Pose& parent_from_child,
                         Frame& parent) const {
  tf2::TransformStorage sample;
  if (!caches_[child] || !caches_[child]->getData(time, sample)) return false;
  parent_from_child = {sample.rotation_, sample.translation_};
  parent = toFrame(sample.frame_id_);
  return true;
}

/// Ends at the target, where a history ends, or where a loop would close.
void EdgeHistories::climb(Frame source, Frame target, ros::Time time) const {
  marks_.begin(caches_.size());
  steps_.assign(1, {source, Tf2Pose()});
  marks_.set(source, 0);
  Tf2Pose parent_from_child;
  Frame parent = 0;
  while (steps_.back().frame != target &&
         read(steps_.back().frame, time, parent_from_child, parent) && !marks_.position(parent)) {
    marks_.set(parent, steps_.size());
    steps_.push_back({parent, parent_from_child * steps_.back().frame_from_source});
  }
}

std::optional<Tf2Pose> EdgeHistories::pose(Frame target, Frame source, ros::Time time) const {
  if (source == target) return Tf2Pose();
  if (std::max(source, target) >= caches_.size()) return std::nullopt;
  climb(source, target, time);
  Tf2Pose frame_from_target;
  Frame frame = target;
  for (std::size_t steps = 0; !marks_.position(frame); ++steps) {
    Tf2Pose parent_from_frame;
    if (steps > caches_.size() || !read(frame, time, parent_from_frame, frame)) return std::nullopt;
    frame_from_target = parent_from_frame * frame_from_target;
  }
  const Tf2Pose& frame_from_source = steps_[*marks_.position(frame)].frame_from_source;
  if (frame == target) return frame_from_source;
  return inverse(frame_from_target) * frame_from_source;
}

}  // namespace link_bounds
