// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a model, kept up to date with tf.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "world/model/model.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {

class LiveBoxes {
 public:
  explicit LiveBoxes(FrameTracker& frames) : frames_(frames) {}

  /// Starts over with a model. The tracker must already use the model's fixed frame. Links that tf
  /// knows get their boxes at once.
  void adopt(std::shared_ptr<const Model> model);

  /// To be called after each update of the poses. Computes the boxes whose poses changed; true if
  /// any box, stamp or problem changed. Always false without a model.
  bool update();

  /// Null until the first adopt().
  const Model* model() const { return model_.get(); }
  const std::shared_ptr<const Model>& sharedModel() const { return model_; }

  /// One per link of the model.
  const std::vector<BoxState>& states() const { return states_; }

  /// The number of the tf frame of link `i`.
  FrameTracker::Frame frame(std::size_t i) const { return link_frames_[i].frame(); }

  /// The pose of link `i` in the fixed frame from which its box was computed, if it has a box.
  const Eigen::Affine3d& pose(std::size_t i) const {
    return poses_[i].pose().fixed_from_frame.affine;
  }

  /// Why link `i` has no box, although it has shapes; kNone if it has a box or no shapes.
  TransformProblem problem(std::size_t i) const { return problems_[i]; }

  /// Why link `i` is incomplete, in words; "" if it is not.
  std::string reason(std::size_t i) const;

 private:
  bool refresh(std::size_t i, const FramePose& pose);
  bool boundWaiting();
  bool drop(std::size_t i, TransformProblem problem);
  void setProblem(std::size_t i, TransformProblem problem);

  FrameTracker& frames_;
  std::shared_ptr<const Model> model_;
  std::vector<TransformBuffer::Hold> link_frames_;
  std::vector<FrameTracker::Handle> poses_;  ///< one per link; empty for links without shapes
  std::vector<TransformProblem> problems_;
  LinkBoxes boxes_;
  std::vector<BoxState> states_;
  std::vector<MovedLink> waiting_;  ///< links whose boxes this update computes at its end
};

}  // namespace link_bounds
