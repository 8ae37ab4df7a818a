// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How one edge of tf moves during a span.
#pragma once

#include <optional>
#include <vector>

#include "world/history/deviation_bound.h"
#include "world/tf/edge_history.h"

namespace link_bounds {

/// All times are in nanoseconds and within the span.
class EdgeMotion {
 public:
  /// `samples`: those between which the edge is interpolated in the span, at least one; see
  /// EdgeHistory::between. They must outlive this.
  explicit EdgeMotion(std::vector<const EdgeSample*> samples) : samples_(std::move(samples)) {}

  const std::vector<const EdgeSample*>& samples() const { return samples_; }

  /// False if the edge has one transform for the whole span.
  bool isMoving() const { return samples_.size() > 1; }

  /// Selects the pair of successive samples whose interval contains this time. The functions below
  /// refer to this pair.
  void seek(std::int64_t time);

  /// The transform that tf2 gives at a time between the two samples.
  Tf2Pose at(std::int64_t time) const;

  /// Bounds of the motion in any part of the interval that lasts `duration`.
  EdgeStep stepIn(std::int64_t duration) const;

  /// True if the edge jumps at the newer sample.
  bool isSudden() const { return motion().step.is_sudden != isLibraryOther(); }

  /// True if the tf2 library, which may be compiled in another way, disagrees on whether the edge
  /// jumps: see step 6 in deviation_bound.h.
  bool isAmbiguous() const { return motion().is_ambiguous; }

  /// With true, at() and isSudden() follow the tf2 library where isAmbiguous(). The default is
  /// false: they follow tf2's formula as it is compiled here.
  void followLibrary(bool is_library) { is_library_ = is_library; }

 private:
  /// The motion between two successive samples.
  struct Motion {
    EdgeStep step;
    bool is_ambiguous;  ///< see isAmbiguous()
  };

  bool hasNext() const { return place_ + 1 < samples_.size(); }
  const EdgeSample& older() const { return *samples_[place_]; }
  const EdgeSample& newer() const { return *samples_[place_ + 1]; }
  /// True if at() must follow the tf2 library and its result differs from the formula here.
  bool isLibraryOther() const { return is_library_ && isAmbiguous(); }
  const Motion& motion() const;
  double partOf(std::int64_t duration) const;

  std::vector<const EdgeSample*> samples_;
  std::size_t place_ = 0;                 ///< index of older() in samples_
  mutable std::optional<Motion> motion_;  ///< from older() to newer(); made on first use
  bool is_library_ = false;
};

}  // namespace link_bounds
