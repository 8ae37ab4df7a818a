// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each message and tick first checks the clock for jumps.
#include "world/bodies/scene_feed.h"

#include <ros/console.h>

#include <utility>

namespace link_bounds {

SceneFeed::SceneFeed(Handlers handlers, std::function<ros::SteadyTime()> steady_now)
    : handlers_(std::move(handlers)),
      object_source_(scene_.objects, handlers_.request_mesh),
      clock_(std::move(steady_now)) {}

void SceneFeed::adopt(std::shared_ptr<const Model> model, ros::Time now) {
  tf_.distrustStampsAhead(now);
  input_.forgetLog();
  scene_.adopt(model, now);
  neighbours_.forgetLog();
  object_source_.reloadMeshes(model->object_meshes, now);
}

void SceneFeed::onTransforms(const std::vector<TransformView>& transforms, bool is_static,
                             const TransformInput::Publisher& publisher, ros::Time now,
                             ros::SteadyTime arrival) {
  observeClock(now);
  input_.add(transforms, is_static, publisher, clock_, now, arrival, tf_);
  has_new_transforms_ = true;
  taken(false, now);
}

void SceneFeed::taken(bool is_changed, ros::Time now) {
  is_changed_ |= is_changed;
  ++taken_;
  if (!joins_) update(now);
}

/// To be called before objects are taken: they are placed as if each earlier transform had been
/// processed at once.
void SceneFeed::updatePoses(ros::Time now) {
  if (std::exchange(has_new_transforms_, false)) is_changed_ |= scene_.update(now);
}

void SceneFeed::update(ros::Time now) {
  if (taken_ == 0) return;
  joined_ += std::exchange(taken_, 0) - 1;
  updatePoses(now);
  if (std::exchange(is_changed_, false)) onNews();
}

void SceneFeed::onMarkers(visualization_msgs::Marker* markers, std::size_t count,
                          const std::string& publisher, ros::Time now) {
  observeClock(now);
  updatePoses(now);
  bool is_changed = false;
  for (std::size_t i = 0; i < count; ++i)
    is_changed |= object_source_.take(std::move(markers[i]), publisher, now);
  taken(is_changed, now);
}

void SceneFeed::onNeighbour(const AxisAlignedBoxArray& boxes, const NeighbourSender& sender,
                            ros::Time now) {
  observeClock(now);
  updatePoses(now);
  taken(neighbours_.take(boxes, sender, now), now);
}

void SceneFeed::onMesh(const MeshRequest& request, const LoadedMesh& mesh, ros::Time now) {
  if (object_source_.fillMesh(request, mesh, now)) onNews();
}

void SceneFeed::onTick(ros::Time now) {
  observeClock(now);
  update(now);
  const bool has_ended = neighbours_.removeEnded(ros::SteadyTime::now(), handlers_.has_left);
  const bool is_changed = scene_.expire(now) || has_ended;
  object_source_.warnOfGivenUp(now);
  if (is_changed) onNews();
}

void SceneFeed::observeClock(ros::Time now) {
  switch (clock_.observe(now)) {
    case ClockWatch::Event::kNone:
      return;
    case ClockWatch::Event::kStarted:
      tf_.startClock(now);
      if (scene_.startClock(now)) onNews();
      return;
    case ClockWatch::Event::kJumpedAhead:
      if (tf_.jumpAhead(now) && scene_.update(now)) onNews();
      return;
    case ClockWatch::Event::kJumpedBack:
      logJump();
      tf_.clear();
      if (scene_.restart(now)) onNews();
      return;
  }
}

void SceneFeed::logJump() {
  const std::string line =
      jump_log_.line("the clock jumped back; forgetting all transforms that are not static",
                     ros::SteadyTime::now());
  if (!line.empty()) ROS_WARN_STREAM(line);
}

/// Reports nothing before the first model.
void SceneFeed::onNews() {
  if (scene_.model()) handlers_.on_news();
}

}  // namespace link_bounds
