// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of objects that come and go, kept up to date with tf and with time.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/mesh_store.h"
#include "live_object.h"
#include "object_key.h"

namespace link_bounds {

/// Until a fixed frame is known the objects are kept and none has a box. All functions that return
/// bool tell whether a box, a stamp or an incomplete name changed.
class LiveObjects {
 public:
  using Objects = std::map<ObjectKey, LiveObject>;

  /// In the order of ~boxes.
  const Objects& objects() const { return objects_; }

  /// Starts over with another fixed frame and timeout [ROS s].
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

  /// After the clock jumped or began to run: ages count from now on.
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

  void follow(LiveObject& object, const TransformSource& tf, ros::Time now);
  void release(const LiveObject& object);
  Objects::iterator erase(Objects::iterator object);
  bool refresh(LiveObject& object, const TransformSource& tf, ros::Time now);
  bool refreshAll(const TransformSource& tf, ros::Time now);
  bool refreshWaiting(const TransformSource& tf, ros::Time now);
  LiveObject::Trouble place(LiveObject& object, const TransformSource& tf, ros::Time now,
                            BoxState& state);
  LiveObject::Trouble placeFollowing(LiveObject& object, BoxState& state);
  LiveObject::Trouble placeOnce(LiveObject& object, const TransformSource& tf, ros::Time now,
                                BoxState& state);

  const std::optional<Eigen::Isometry3d>& poseAt(std::int64_t stamp, FollowedFrame::Frame frame,
                                                 const TransformSource& tf);

  Objects objects_;
  std::map<FollowedFrame::Frame, HeaderFrame> frames_;
  std::optional<FollowedFrame::Target> target_;
  std::optional<PastPose> past_pose_;  ///< until tf says more
  std::vector<ObjectKey> given_up_;
  std::uint64_t structure_ = 0;
  std::size_t waiting_ = 0;  ///< objects whose transform is not there yet
};

}  // namespace link_bounds
