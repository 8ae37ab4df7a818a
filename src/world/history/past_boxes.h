// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a copied scene at the time of a request.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "world/history/past_scene.h"
#include "world/history/swept_box.h"
#include "world/moment/moment.h"
#include "world/tf/frame_tracker.h"

namespace link_bounds {

struct PastBoxes {
  Moment moment;  ///< header stamp: that of the request; if that is 0, the newest of the boxes
  std::string problem;   ///< why the first incomplete body is incomplete, and how many more are
  std::size_t late = 0;  ///< number of boxes that were not made in time
};

/// Makes the boxes, one after the other. Both arguments of the constructor must outlive this.
class PastBoxMaker {
 public:
  PastBoxMaker(PastScene& scene, const BoxRequest& request);
  PastBoxMaker(const PastBoxMaker&) = delete;
  PastBoxMaker& operator=(const PastBoxMaker&) = delete;

  /// Works for about `budget`, on at least one body; true when all bodies are done. Once
  /// `gives_up`, which is called often, returns true, the remaining bodies are incomplete and have
  /// no box.
  bool proceed(std::chrono::nanoseconds budget, const std::function<bool()>& gives_up);

  /// To be called once, after proceed() returned true.
  PastBoxes take();

 private:
  using Frame = TransformBuffer::Frame;

  /// A box with its pose, or why there is none.
  struct Made {
    std::optional<Aabb> box;
    std::int64_t stamp = 0;
    std::string problem;
    Eigen::Affine3d target_from_body = Eigen::Affine3d::Identity();
  };

  /// The pose of a frame in the frame of the request.
  struct Pose {
    std::optional<Eigen::Affine3d> target_from_frame;
    std::int64_t stamp = 0;  ///< 0: all its transforms are static
    std::string problem;     ///< if there is no pose
  };

  void makeNext(const std::function<bool()>& gives_up);
  void add(const PastBody& body, const Made& made);
  Made make(const PastBody& body, const std::function<bool()>& gives_up);
  SweptBox sweep(const PastBody& body, std::int64_t end,
                 const std::function<bool()>& gives_up) const;
  Pose poseOf(Frame frame);
  Pose latest(Frame frame);
  const std::string& targetName() const { return tf_.name(scene_.target); }
  const std::string& nameOf(const PastBody& body) const { return tf_.name(*body.frame); }

  PastScene& scene_;
  TransformBuffer& tf_;
  const BoxRequest& request_;
  FrameTracker tracker_;
  PastBoxes boxes_;
  std::size_t made_ = 0;        ///< number of bodies that are done
  std::size_t incomplete_ = 0;  ///< number of these that are incomplete
  bool is_given_up_ = false;
};

/// Makes all boxes in one call. `gives_up` as for PastBoxMaker::proceed().
PastBoxes pastBoxes(PastScene& scene, const BoxRequest& request,
                    const std::function<bool()>& gives_up);

/// Why no boxes can be computed for the scene, in words; "" if they can.
std::string whyRefused(const PastScene& scene);

}  // namespace link_bounds
