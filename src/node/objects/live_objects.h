// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of objects that come and go, kept up to date with tf and with time.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/robot/mesh/mesh_store.h"
#include "node/names/object_key.h"
#include "node/objects/live_object.h"

namespace link_bounds {

/// Until a fixed frame is known the objects are kept and none has a box. All functions that return
/// bool tell whether a box, a stamp or an incomplete name changed.
class LiveObjects {
 public:
  using Objects = std::map<ObjectKey, LiveObject>;

  /// In the order of ~boxes.
  const Objects& objects() const { return objects_; }

  /// Starts over with another fixed frame and timeout [ROS s]. Objects that were placed once are
  /// carried over by the newest transform between the two frames, as soon as there is one.
  void adopt(const std::string& fixed_frame, double timeout, TransformSource& tf, ros::Time now);

  /// Adds an object or replaces it. Until the new one can be placed, the box of the one before
  /// goes on, named as incomplete.
  bool put(const ObjectKey& key, ObjectContent content, TransformSource& tf, ros::Time now);
  bool remove(const ObjectKey& key);
  bool removeAll();

  /// The points of a mesh that objects wait for or have in another version, or why there are none.
  bool fillMesh(const std::string& uri, const LoadedMesh& mesh, const TransformSource& tf,
                ros::Time now);

  /// To be called after each tf message, and before any other function sees its transforms.
  bool update(const TransformSource& tf, ros::Time now);

  /// After the clock jumped back or began to run. What is left of a lifetime stays as it was,
  /// waiting begins anew, and no stamp of a box is ahead of `now`.
  bool restart(const TransformSource& tf, ros::Time now);

  /// To be called now and then: ends lifetimes, finds stale frames, gives up waiting.
  bool expire(const TransformSource& tf, ros::Time now);

  /// The objects that were given up since the last call and still are.
  std::vector<const LiveObject*> takeGivenUp();

 private:
  /// A frame that objects follow, and how many do.
  struct HeaderFrame {
    FollowedFrame followed;
    std::size_t users = 0;
    bool is_news = false;
  };

  /// What tf last said of a frame at a time: objects of one message have it in common.
  struct PastPose {
    FollowedFrame::Frame frame;
    std::int64_t stamp;
    std::optional<Eigen::Isometry3d> fixed_from_frame;
  };

  std::int64_t observe(ros::Time now);
  std::int64_t stampOf(const ObjectContent& content, std::int64_t now) const;
  void follow(LiveObject& object, const TransformSource& tf, ros::Time now);
  void release(const LiveObject& object);
  Objects::iterator erase(Objects::iterator object);
  bool refresh(LiveObject& object, const TransformSource& tf, ros::Time now);
  bool refreshAll(const TransformSource& tf, ros::Time now);
  bool refreshNotCarried(const TransformSource& tf, ros::Time now);
  bool refreshWaiting(const TransformSource& tf, ros::Time now);
  LiveObject::Trouble place(LiveObject& object, const TransformSource& tf, ros::Time now,
                            BoxState& state);
  LiveObject::Trouble placeFollowing(LiveObject& object, BoxState& state);
  LiveObject::Trouble placeOnce(LiveObject& object, const TransformSource& tf, ros::Time now,
                                BoxState& state);

  bool hasWaitedLong(const LiveObject& object, ros::Time now) const;
  void moveTo(FollowedFrame::Frame fixed_frame);
  bool findCarries(const TransformSource& tf, ros::Time now);
  std::optional<Eigen::Isometry3d> carried(const Placement& placement) const;
  const std::optional<Eigen::Isometry3d>& poseAt(std::int64_t stamp, FollowedFrame::Frame frame,
                                                 const TransformSource& tf);

  Objects objects_;
  std::map<FollowedFrame::Frame, HeaderFrame> frames_;
  std::optional<FollowedFrame::Target> target_;
  std::string fixed_frame_name_;

  /// Transforms to the fixed frame from earlier ones in which objects were placed. Once found, a
  /// transform stays.
  std::map<FollowedFrame::Frame, std::optional<Eigen::Isometry3d>> carries_;

  std::optional<PastPose> past_pose_;  ///< until tf says more
  std::vector<ObjectKey> given_up_;
  std::uint64_t structure_ = 0;
  std::size_t waiting_ = 0;      ///< objects whose transform is not there yet
  std::int64_t last_now_ = 0;    ///< the newest time since the clock jumped back
  std::int64_t newest_now_ = 0;  ///< the newest time before any jump back
};

}  // namespace link_bounds
