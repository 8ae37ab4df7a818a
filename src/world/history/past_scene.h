// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A request for boxes of the past, and a copy of all data that its answer needs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/live_object.h"
#include "world/tf/tf_excerpt.h"

namespace link_bounds {

struct Model;

struct BoxRequest {
  std::int64_t stamp = 0;          ///< [ns]; 0: the latest pose of each body
  std::int64_t span = 0;           ///< of motion before the stamp [ns]; 0: boxes at the stamp
  std::string frame;               ///< "": the fixed frame of the model
  std::vector<std::string> names;  ///< empty: all links and objects
  bool has_robot_frames = false;   ///< whether to fill PastScene::robot_frames
  /// True: a neighbour's box in another frame than the fixed one moves with its frame, as a box of
  /// stamp 0 does. False: it stays at its last place.
  bool neighbours_follow = false;
};

/// Where an object was on a link when it was placed.
struct HeldPlace {
  std::size_t link;  ///< of Model::robot
  Eigen::Affine3d link_from_body;
};

/// A link or an object, without its pose.
struct PastBody {
  const BoundedLink* bounded = nullptr;         ///< its shapes, held by the model or by `object`
  std::optional<std::size_t> link;              ///< its index in the model
  std::shared_ptr<const ObjectContent> object;  ///< null for links
  /// The frame of the excerpt with which the body moves. Nothing: it has no box at any time.
  std::optional<TransformBuffer::Frame> frame;
  /// The header frame of an incomplete object that follows this frame: the nearest link above this
  /// frame carries the object. Only if BoxRequest::has_robot_frames is set.
  std::optional<TransformBuffer::Frame> header;
  /// The pose in `frame` of an object that was placed once. Nothing: the body's frame is `frame`.
  std::optional<Eigen::Affine3d> frame_from_body;
  /// The place on its link of an attached object that was placed once, if tf knows the pose of the
  /// link at that time. Only if BoxRequest::has_robot_frames is set.
  std::optional<HeldPlace> held;
  /// True for an object that was placed once, while another frame was the fixed frame.
  bool is_carried_over = false;
  std::int64_t stamp = 0;    ///< of the transform that placed it [ns]
  bool is_outdated = false;  ///< an object that may have been placed before the clock jumped back
  bool incomplete = false;   ///< at any time
  std::string reason;        ///< why it is incomplete, in words
};

/// Shares no mutable data with the scene.
struct PastScene {
  PastScene(const BoxRequest& request, std::int64_t stale_before)
      : excerpt(request.stamp, request.span, stale_before) {}

  const std::string& frameName() const { return excerpt.buffer().name(target); }

  std::shared_ptr<const Model> model;
  ros::Time now;  ///< when the copy began, or began anew after a jump of the clock
  TfExcerpt excerpt;
  TransformBuffer::Frame target = 0;  ///< the frame of the request
  std::vector<PastBody> bodies;       ///< in the order of ~boxes
  /// One frame of the excerpt per link of Model::robot; nothing if tf has no frame of the link.
  std::vector<std::optional<TransformBuffer::Frame>> robot_frames;
  std::vector<std::string> unknown_names;    ///< requested, but of no link and no object
  std::optional<std::string> unknown_frame;  ///< the frame of the request, if tf does not know it
};

}  // namespace link_bounds
