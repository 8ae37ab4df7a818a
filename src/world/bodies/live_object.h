// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One object: its content and its box.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "link_bounds/geometry/box/box_groups.h"
#include "link_bounds/geometry/shape/link_boxes.h"
#include "link_bounds/robot/mesh/mesh_store.h"
#include "world/bodies/marker_shape.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {

/// The URI of a mesh, shared by all objects that use it. Once the last of them is gone, nobody
/// waits for the mesh.
using MeshUse = std::shared_ptr<const std::string>;

/// An object as its publisher describes it. Shared with other threads, so it never changes.
struct ObjectContent {
  BoundedLink bounded;     ///< its shapes, in the header frame, and the name of its box
  std::string frame;       ///< header frame, tf name
  std::int64_t stamp = 0;  ///< [ns]; placed once by the transform at this time. 0: follows tf
  ros::Duration lifetime;  ///< ROS time from receipt; 0 or less: for ever
  std::string mesh_uri;    ///< of its mesh, if any; while that loads, the shape has no points
  MeshUse mesh_use;        ///< null without a mesh
  /// The file of the mesh has changed and is read again. Until then the old points stay.
  bool is_read_again = false;
  Drawing drawing;        ///< what the marker draws with the shapes
  std::string publisher;  ///< name of the node that sent it
  /// The object is a box of another node. It follows its frame, and its box is never stamped newer
  /// than `stamp`; 0: static.
  bool is_neighbour = false;
  bool is_static = false;  ///< a neighbour's box that never falls silent
  /// Why it has no box if another object has its name, else "". A marker gets its box when the name
  /// is free; for a neighbour no shapes are kept.
  std::string refused_name;

  /// Whether the object moves with its header frame. A refused marker has no frame.
  bool follows() const { return (stamp == 0 || is_neighbour) && !frame.empty(); }
  bool isLoading() const {
    return !mesh_uri.empty() && bounded.isWhole() && !bounded.shapes.front().points;
  }
  /// Whether a box can be computed. A neighbour's box may cover only part of its link.
  bool isBounded() const {
    if (is_neighbour) return !bounded.shapes.empty();
    return is_read_again || (bounded.isWhole() && !isLoading());
  }

  /// A `mesh` without points and without error is still loading: points of an older file then stay.
  void setMesh(const LoadedMesh& mesh);
};

/// True if both have the same shapes in their header frames and draw them in the same way.
bool isSameBody(const ObjectContent& a, const ObjectContent& b);

/// True if both are the same body at the same place and time. Publisher and lifetime are not
/// compared.
bool isSame(const ObjectContent& a, const ObjectContent& b);

/// The pose at which an object was placed once. A later change of the fixed frame does not change
/// it.
struct ObjectPlacement {
  FrameTracker::Frame fixed_frame;  ///< the fixed frame at that time
  Eigen::Affine3d fixed_from_header;
  /// The object was sent again since. It stays there if tf does not know its new place.
  bool is_earlier = false;
};

/// How sure it is that an object's stamp is of the time since the clock last jumped back, in
/// ascending order. Without a jump back, a stamp is known.
enum class StampTime {
  kNotSent,   ///< not sent since then, or no transform at its stamp came in time
  kOutside,   ///< sent since then, but the clock has not been at its stamp
  kRepeated,  ///< sent with its old stamp: the sender may not know of the jump
  kKnown      ///< the stamp is of the time since the jump
};

/// The input from which a box was computed.
struct BoxedObject {
  std::shared_ptr<const ObjectContent> content;
  Eigen::Affine3d fixed_from_header;
};

/// One object and its box. Times are nanoseconds of ROS time.
struct LiveObject {
  LiveObject() = default;
  LiveObject(const LiveObject&) = delete;
  LiveObject& operator=(const LiveObject&) = delete;

  std::shared_ptr<const ObjectContent> content;
  LinkBoxes boxes;                ///< its single link is content->bounded
  TransformBuffer::Hold hold;     ///< of content->frame
  FrameTracker::Frame frame = 0;  ///< the number of content->frame
  FrameTracker::Handle header;    ///< pose of content->frame, if the object follows it
  FrameTracker::Handle needed;    ///< pose of content->frame, see LiveObjects::needPlaces()
  std::optional<ObjectPlacement> placement;
  std::int64_t stamp = 0;     ///< the content's stamp, or the time of a later jump back
  std::int64_t received = 0;  ///< last receipt; clock jumps shift it to keep the lifetime left
  ros::Duration lifetime;     ///< the lifetime in the last receipt
  std::string sender;         ///< the publisher of the last receipt
  bool is_silent = false;     ///< a neighbour that sent nothing for `timeout`
  bool was_static = false;    ///< endStatic() made it non-static
  /// Unless this is kKnown, the object has a box, but its place relative to a link is unknown.
  StampTime stamp_time = StampTime::kKnown;
  std::int64_t waiting_since = 0;   ///< start of the wait for the transform at its stamp
  std::int64_t unplaced_since = 0;  ///< start of the wait; a new receipt does not restart it
  TransformProblem problem = TransformProblem::kNone;
  BoxState state;
  BoxedObject boxed;  ///< the input of `state.box`, if any; maybe an earlier content
};

/// Why an object that came after `other` cannot have the same name.
std::string whyNameRefused(const LiveObject& other);

}  // namespace link_bounds
