// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Everything that has a box: the links of the robot, then objects.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "world/bodies/live_boxes.h"
#include "world/bodies/live_objects.h"

namespace link_bounds {

/// The current state of a link or an object. Valid until the scene changes.
struct SceneBody {
  const std::string& name;  ///< the name of its box
  const BoxState& state;
  std::optional<std::size_t> link;  ///< its index in the model
  const ObjectKey* key;             ///< null for links
  const LiveObject* object;         ///< null for links
};

/// The input from which the box of a body is computed. Valid until the scene changes.
struct BoxSource {
  const BoundedLink& bounded;                          ///< its shapes
  const std::shared_ptr<const ObjectContent>& object;  ///< null for links
  TransformBuffer::Frame frame;                        ///< the frame that it moves with
  const Eigen::Affine3d* frame_from_body;              ///< null: identity
};

/// All functions that return bool tell whether a box, its content, a stamp or an incomplete name
/// changed.
struct Scene {
  explicit Scene(TransformBuffer& tf) : frames(tf), links(frames), objects(frames) {}

  /// Starts over with a model. Objects stay.
  void adopt(std::shared_ptr<const Model> model, ros::Time now);

  /// To be called after each tf message.
  bool update(ros::Time now);

  /// After the clock began to run.
  bool startClock(ros::Time now);

  /// After the clock jumped back, when tf was cleared.
  bool restart(ros::Time now);

  /// To be called now and then: drops boxes that have become too old.
  bool expire(ros::Time now);

  /// Null before the first adopt(); nothing is published until then.
  const Model* model() const { return links.model(); }

  std::size_t size() const { return links.states().size() + objects.objects().size(); }

  /// Calls visit(SceneBody) for each link and object, with or without a box, in the order of
  /// ~boxes.
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::size_t i = 0; i < links.states().size(); ++i)
      visit(SceneBody{links.model()->links[i].name, links.states()[i], i, nullptr, nullptr});
    for (const auto& [key, object] : objects.objects())
      visit(SceneBody{object.content->bounded.name, object.state, std::nullopt, &key, &object});
  }

  /// Why the body is incomplete, in words; "" if it is not.
  std::string reason(const SceneBody& body) const;

  /// The body must have a box or be a link with shapes.
  BoxSource boxSource(const SceneBody& body) const;

  /// The pose in the fixed frame from which its box was computed. There must be a box.
  const Eigen::Affine3d& pose(const SceneBody& body) const;

  FrameTracker frames;
  LiveBoxes links;
  LiveObjects objects;
};

/// The state of a group of links and objects; see BoxGroup.
BoxState groupState(const SceneGroup& group, const Scene& scene);

}  // namespace link_bounds
