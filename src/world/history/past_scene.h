// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a request for boxes of the past asks for, and a copy of all that its answer needs.
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
  std::int64_t stamp = 0;          ///< [ns]; 0: each body as new as tf has it
  std::int64_t span = 0;           ///< [ns]; 0: boxes at the stamp
  std::string frame;               ///< "": the fixed frame of the model
  std::vector<std::string> names;  ///< none: all links and objects
  bool has_robot_frames = false;   ///< PastScene::robot_frames is wanted, too
  /// A neighbour's box of another frame than the fixed one moves with that frame, as one of stamp 0
  /// does; else it stays where it is.
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
  /// Of the excerpt; with which it moves. Nothing: there is no box at any time.
  std::optional<TransformBuffer::Frame> frame;
  /// Header frame of an incomplete object that follows it: what carries the object is above it.
  /// Only where BoxRequest::has_robot_frames is set.
  std::optional<TransformBuffer::Frame> header;
  /// Where an object was placed once in that frame; else it is the frame.
  std::optional<Eigen::Affine3d> frame_from_body;
  /// Of an object that was placed once and is attached to a link, if tf knows the link at that
  /// time. Only where BoxRequest::has_robot_frames is set.
  std::optional<HeldPlace> held;
  /// An object that was placed once, in another fixed frame than the present one.
  bool is_carried_over = false;
  std::int64_t stamp = 0;    ///< of the transform that placed it [ns]
  bool is_outdated = false;  ///< an object that may have been placed before the clock jumped back
  bool incomplete = false;   ///< whatever the time
  std::string reason;        ///< why, in words
};

/// Shares nothing that changes.
struct PastScene {
  PastScene(const BoxRequest& request, std::int64_t stale_before)
      : excerpt(request.stamp, request.span, stale_before) {}

  const std::string& frameName() const { return excerpt.buffer().name(target); }

  std::shared_ptr<const Model> model;
  ros::Time now;  ///< when it was copied
  TfExcerpt excerpt;
  TransformBuffer::Frame target = 0;  ///< the frame of the request
  std::vector<PastBody> bodies;       ///< in the order of ~boxes
  /// Of the excerpt, one per link of Model::robot; nothing where tf has none.
  std::vector<std::optional<TransformBuffer::Frame>> robot_frames;
  std::vector<std::string> unknown_names;    ///< of no link and no object
  std::optional<std::string> unknown_frame;  ///< the frame of the request, if tf does not know it
};

}  // namespace link_bounds
