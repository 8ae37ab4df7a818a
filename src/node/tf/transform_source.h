// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// tf as the node sees it: histories that give poses, and a FrameTree of what arrived when.
#pragma once

#include <ros/time.h>

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <vector>

#include "node/tf/edge_histories.h"
#include "node/tf/frame_tree.h"
#include "node/tf/tf_message.h"

namespace link_bounds {

struct StampedPose {
  Eigen::Isometry3d world_from_link;
  std::int64_t stamp = 0;  ///< nanoseconds; latest common time of the path, 0 if it is all static
};

/// What was heard before this [ns of ROS time] is stale at `now`. `timeout` in seconds, 0: never.
inline std::int64_t staleBefore(double timeout, ros::Time now) {
  constexpr std::int64_t kBeforeAllTimes = std::numeric_limits<std::int64_t>::min();
  const double before = static_cast<double>(now.toNSec()) - timeout * 1e9;
  const bool is_never = timeout <= 0 || before <= static_cast<double>(kBeforeAllTimes);
  return is_never ? kBeforeAllTimes : static_cast<std::int64_t>(before);
}

/// A transform that was not taken.
struct Refusal {
  std::size_t index;   ///< its place in the message
  const char* reason;  ///< with the remedy
};

/// What became of all transforms since the start.
struct TfIntake {
  std::uint64_t taken = 0;
  std::uint64_t late = 0;      ///< of those, with a stamp before the newest one of their frame
  std::uint64_t repeated = 0;  ///< not taken: the stamp was there already
  std::uint64_t too_old = 0;   ///< not taken
  std::uint64_t unusable = 0;  ///< not taken: see whyRefused
  std::uint64_t dropped = 0;   ///< not taken: sent before the clock jumped
};

class TransformSource {
 public:
  using Frame = FrameTree::Frame;

  /// Adds the transforms of one message, received at `now`. Those that are refused change nothing.
  /// Not told are a stamp that is there already, and one that is too old while others are taken.
  std::vector<Refusal> add(const std::vector<TransformView>& transforms, bool is_static,
                           ros::Time now);

  /// The latest common time [ns] of `path`, which is tree().path(source, target); 0 if it is all
  /// static.
  std::int64_t latestCommonTime(Frame source, const std::vector<Frame>& path) const;

  /// True if at that time each edge of the path had the parent that it has now, and what is above
  /// the path had, too: there may have been a loop.
  bool wasPath(const std::vector<Frame>& path, std::int64_t stamp) const;

  /// The pose at the latest common time, interpolated; as tf2's lookupTransform(target, source, 0).
  /// `path` is tree().path(source, target). The quaternion is normalised; the result may still not
  /// be finite. Nothing if a history does not reach that time.
  std::optional<StampedPose> latest(Frame target, Frame source,
                                    const std::vector<Frame>& path) const;

  /// The pose at that time [ns], interpolated, by the edges as they were; as
  /// lookupTransform(target, source, stamp). A frame in itself needs no transform.
  std::optional<Eigen::Isometry3d> at(Frame target, Frame source, std::int64_t stamp) const;

  /// Forgets everything that is not static, after a clock jump.
  void clear();

  /// Counts transforms that were sent before a clock jump, instead of add().
  void countDropped(std::size_t count) { intake_.dropped += count; }

  /// An edge whose newest stamp is so far ahead of `now` that it makes tf refuse all that honest
  /// clocks send may begin anew: the next transform that is too old replaces its history.
  void distrustStampsAhead(ros::Time now);

  const TfIntake& intake() const { return intake_; }
  const EdgeHistories& histories() const { return histories_; }
  FrameTree& tree() { return tree_; }
  const FrameTree& tree() const { return tree_; }

 private:
  const char* insert(const TransformView& transform, bool is_static, std::int64_t now);
  bool isTooOld(Frame child, std::int64_t stamp) const;
  const char* refuse(Frame child, std::int64_t stamp, std::int64_t now);

  EdgeHistories histories_;
  FrameTree tree_;
  TfIntake intake_;
};

}  // namespace link_bounds
