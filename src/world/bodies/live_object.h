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

/// The URI of a mesh, shared by all objects that have it: when the last one is gone, nobody waits
/// for the mesh.
using MeshUse = std::shared_ptr<const std::string>;

/// An object as its publisher describes it. Shared with other threads, so it never changes.
struct ObjectContent {
  BoundedLink bounded;  ///< its shapes, in the header frame; the name is that of the box
  std::string frame;    ///< header frame, tf name
  std::int64_t stamp =
      0;  ///< nanoseconds; placed once by the transform at this time. 0: follows tf
  ros::Duration lifetime;  ///< ROS time from receipt; 0 or less: for ever
  std::string mesh_uri;    ///< of a mesh, whose shape has no points while it loads
  MeshUse mesh_use;        ///< null without a mesh
  /// The file of the mesh has changed and is read again: the points are those that it had.
  bool is_read_again = false;
  Drawing drawing;        ///< what the marker draws with the shapes
  std::string publisher;  ///< name of the node that sent it
  /// A box of another node. It follows its frame, and no box of it is newer than `stamp`; 0:
  /// static.
  bool is_neighbour = false;
  bool is_static = false;  ///< a neighbour's that never falls silent
  /// Why it has no box, because another object has its name; "" if none has. A marker gets its box
  /// when the name is free; of a neighbour no shapes are kept.
  std::string refused_name;

  /// A refused marker has no frame.
  bool follows() const { return (stamp == 0 || is_neighbour) && !frame.empty(); }
  bool isLoading() const {
    return !mesh_uri.empty() && bounded.isWhole() && !bounded.shapes.front().points;
  }
  /// False if there is nothing to make a box of. A neighbour's box may cover only part of its link.
  bool isBounded() const {
    if (is_neighbour) return !bounded.shapes.empty();
    return is_read_again || (bounded.isWhole() && !isLoading());
  }

  /// A `mesh` without points and error is not there yet: points of an older file then stay.
  void setMesh(const LoadedMesh& mesh);
};

/// True if both have the same shapes in their header frames, drawn in the same way.
bool isSameBody(const ObjectContent& a, const ObjectContent& b);

/// True if both are the same body at the same place and time. Publisher and lifetime are not
/// compared.
bool isSame(const ObjectContent& a, const ObjectContent& b);

/// Where an object was placed once. Another fixed frame later does not change this.
struct ObjectPlacement {
  FrameTracker::Frame fixed_frame;  ///< of that time
  Eigen::Affine3d fixed_from_header;
  /// The object was sent again since, and stays there if tf knows no more.
  bool is_earlier = false;
};

/// What is known of an object's stamp since the clock last jumped back: the later, the more.
enum class StampTime {
  kNotSent,   ///< nothing: the object was not sent since then, or tf did not get its stamp
  kOutside,   ///< it was, but the clock has not been at its stamp since then
  kRepeated,  ///< it had that stamp before, too: who sends it may know nothing of the jump
  kKnown      ///< the stamp is of the time since then
};

/// What a box was computed from.
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
  LinkBoxes boxes;                ///< of the one link that content->bounded is
  TransformBuffer::Hold hold;     ///< of content->frame
  FrameTracker::Frame frame = 0;  ///< that of content->frame
  FrameTracker::Handle header;    ///< of content->frame, if the object follows it
  FrameTracker::Handle needed;    ///< of content->frame, see LiveObjects::needPlaces()
  std::optional<ObjectPlacement> placement;
  std::int64_t stamp = 0;     ///< that of the content, or the time of a later jump back
  std::int64_t received = 0;  ///< last receipt; clock jumps shift it, the remaining lifetime stays
  ros::Duration lifetime;     ///< that of the last receipt
  std::string sender;         ///< the publisher of the last receipt
  bool is_silent = false;     ///< a neighbour's: nothing was received for `timeout`
  bool was_static = false;    ///< and see LiveObjects::endStatic()
  /// Unless it is known, the object has a box, but where it is on a link is not known.
  StampTime stamp_time = StampTime::kKnown;
  std::int64_t waiting_since = 0;   ///< for the transform at its stamp
  std::int64_t unplaced_since = 0;  ///< waits since then, also while it is sent again
  TransformProblem problem = TransformProblem::kNone;
  BoxState state;
  BoxedObject boxed;  ///< if there is a box: what it belongs to, maybe an earlier content
};

/// Why an object that came after `other` cannot have the same name.
std::string whyNameRefused(const LiveObject& other);

}  // namespace link_bounds
