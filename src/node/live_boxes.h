// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a model, kept up to date with tf.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model.h"
#include "transform_source.h"

namespace link_bounds {

class LiveBoxes {
 public:
  /// What keeps a link from having a box, besides its own geometry.
  enum class Trouble { kNone, kNoTransform, kStale, kPoseNotFinite };

  /// Starts over with a model; boxes are there at once where tf knows the link.
  void adopt(std::shared_ptr<const Model> model, TransformSource& tf, ros::Time now);

  /// To be called after each tf message. Recomputes what the message touched; true if any box,
  /// stamp or trouble changed. Without a model nothing ever does.
  bool update(const TransformSource& tf, ros::Time now);

  /// Recomputes everything, as is needed after a clock jump; true if anything changed.
  bool updateAll(const TransformSource& tf, ros::Time now);

  /// Drops boxes of links that have become stale; true if there were any.
  bool expire(const TransformSource& tf, ros::Time now);

  /// Null until the first adopt().
  const Model* model() const { return model_.get(); }

  /// One per link of the model.
  const std::vector<BoxState>& states() const { return states_; }

  /// The pose of link `i` in the fixed frame, if it has a box: that of the box.
  const Eigen::Isometry3d& pose(std::size_t i) const { return poses_[i]; }

  /// Why link `i` is incomplete, in words; "" if it is not.
  std::string reason(std::size_t i) const;

 private:
  struct Link {
    FrameTree::Frame frame = 0;
    std::optional<std::vector<FrameTree::Frame>> path;  ///< edges from the link to fixed frame
    Trouble trouble = Trouble::kNoTransform;
  };

  bool findPath(Link& link, const FrameTree& tree) const;
  bool isTouched(const Link& link, const FrameTree& tree) const;
  bool isStale(const Link& link, const FrameTree& tree, ros::Time now) const;
  bool refresh(std::size_t i, const TransformSource& tf, ros::Time now);
  Trouble place(std::size_t i, const TransformSource& tf, ros::Time now, BoxState& state);

  std::shared_ptr<const Model> model_;
  FrameTree::Frame fixed_frame_ = 0;
  std::uint64_t structure_ = 0;
  std::vector<Link> links_;
  std::vector<LinkReach> reaches_;
  std::vector<BoxState> states_;
  std::vector<Eigen::Isometry3d> poses_;
};

}  // namespace link_bounds
