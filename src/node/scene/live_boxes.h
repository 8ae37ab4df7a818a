// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a model, kept up to date with tf.
#pragma once

#include <memory>
#include <vector>

#include "node/loading/model.h"
#include "node/tf/pose_tree.h"

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
  const Eigen::Affine3d& pose(std::size_t i) const {
    return poses_.node(i)->fixed_from_frame.affine;
  }

  /// Why link `i` is incomplete, in words; "" if it is not.
  std::string reason(std::size_t i) const;

 private:
  bool refreshNews(ros::Time now);
  bool refresh(std::size_t i, std::int64_t stale_before);
  bool boundWaiting();
  bool drop(std::size_t i, Trouble trouble);
  void describe(std::size_t i, Trouble trouble);

  std::shared_ptr<const Model> model_;
  PoseTree poses_;  ///< of the links
  std::vector<Trouble> troubles_;
  LinkBoxes boxes_;
  std::vector<BoxState> states_;
  std::vector<MovedLink> waiting_;  ///< for a box, at the end of one update
};

}  // namespace link_bounds
