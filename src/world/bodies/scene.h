// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Everything that has a box: the links of the robot, then objects.
#pragma once

#include <memory>

#include "world/bodies/live_boxes.h"
#include "world/bodies/live_objects.h"

namespace link_bounds {

/// All functions that return bool tell whether a box, a stamp or an incomplete name changed.
struct Scene {
  explicit Scene(TransformBuffer& tf) : frames(tf), links(frames), objects(frames) {}

  /// Starts over with a model. Objects stay.
  void adopt(std::shared_ptr<const Model> model, ros::Time now);

  /// To be called after each tf message.
  bool update(ros::Time now);

  /// After the clock jumped back, when tf was cleared, or began to run.
  bool restart(ros::Time now);

  /// To be called now and then: finds what has become too old.
  bool expire(ros::Time now);

  /// Null until the first model is there; nothing is published before.
  const Model* model() const { return links.model(); }

  /// Calls visit(name, state) for each box there is or should be, in the order of ~boxes.
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::size_t i = 0; i < links.states().size(); ++i)
      visit(links.model()->links[i].name, links.states()[i]);
    for (const auto& [key, object] : objects.objects())
      visit(object.content->bounded.name, object.state);
  }

  FrameTracker frames;
  LiveBoxes links;
  LiveObjects objects;
};

/// The state of a group of links and objects; see BoxGroup.
BoxState groupState(const SceneGroup& group, const Scene& scene);

}  // namespace link_bounds
