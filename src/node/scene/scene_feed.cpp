// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The clock is observed before anything else.
#include "node/scene/scene_feed.h"

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
  scene_.adopt(std::move(model), now);
  object_source_.reloadMeshes();
}

void SceneFeed::onTransforms(const std::vector<TransformView>& transforms, bool is_static,
                             const TransformInput::Publisher& publisher, ros::Time now) {
  observeClock(now);
  input_.add(transforms, is_static, publisher, clock_, now, tf_);
  if (scene_.update(now)) onNews();
}

/// All markers of one message lead to one report.
void SceneFeed::onMarkers(visualization_msgs::Marker* markers, std::size_t count,
                          const std::string& publisher, ros::Time now) {
  observeClock(now);
  bool is_changed = false;
  for (std::size_t i = 0; i < count; ++i)
    is_changed |= object_source_.take(std::move(markers[i]), publisher, now);
  if (is_changed) onNews();
}

void SceneFeed::onNeighbour(const AxisAlignedBoxArray& boxes, const std::string& sender,
                            ros::Time now) {
  observeClock(now);
  if (object_source_.takeNeighbour(boxes, sender, now)) onNews();
}

void SceneFeed::onMesh(const std::string& uri, const LoadedMesh& mesh, ros::Time now) {
  if (object_source_.fillMesh(uri, mesh, now)) onNews();
}

void SceneFeed::onTick(ros::Time now) {
  observeClock(now);
  const bool is_changed = scene_.expire(now);
  object_source_.warnOfGivenUp(now);
  if (is_changed) onNews();
}

void SceneFeed::observeClock(ros::Time now) {
  switch (clock_.observe(now)) {
    case ClockWatch::Event::kNone:
      return;
    case ClockWatch::Event::kStarted:
      tf_.startClock(now);
      if (scene_.restart(now)) onNews();
      return;
    case ClockWatch::Event::kJumpedBack:
      ROS_WARN("the clock jumped back; forgetting all transforms that are not static");
      tf_.clear();
      if (scene_.restart(now)) onNews();
      return;
  }
}

/// Nothing is reported before the first model.
void SceneFeed::onNews() {
  if (scene_.model()) handlers_.on_news();
}

}  // namespace link_bounds
