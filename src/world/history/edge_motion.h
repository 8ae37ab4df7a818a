// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How one edge of tf moves during a span.
#pragma once

#include <optional>
#include <vector>

#include "world/history/deviation_bound.h"
#include "world/tf/edge_history.h"

namespace link_bounds {

/// Times are nanoseconds and lie in the span.
class EdgeMotion {
 public:
  /// The samples that decide the edge's transforms in the span, at least one: see
  /// EdgeHistory::between. They must stay in memory.
  explicit EdgeMotion(std::vector<const EdgeSample*> samples) : samples_(std::move(samples)) {}

  const std::vector<const EdgeSample*>& samples() const { return samples_; }

  /// Otherwise it has one transform for the whole span.
  bool isMoving() const { return samples_.size() > 1; }

  /// Goes to the two samples that decide the transforms from this time on, until the next sample.
  void seek(std::int64_t time);

  /// What tf2 gives at a time between these two samples.
  Tf2Pose at(std::int64_t time) const;

  /// How the edge moves during a part of the time between these two samples.
  EdgeStep stepIn(std::int64_t duration) const;

  /// True if the edge jumps at the newer of these two samples.
  bool isSudden() const { return motion().step.is_sudden != isLibraryOther(); }

  /// True if the library tf2 decides otherwise whether it does, as it may be compiled in another
  /// way: see step 6 in deviation_bound.h.
  bool isAmbiguous() const { return motion().is_ambiguous; }

  /// Whether at() and isSudden() decide as the library tf2 does, also where isAmbiguous(). By
  /// default they do not.
  void followLibrary(bool is_library) { is_library_ = is_library; }

 private:
  /// Between two samples.
  struct Motion {
    EdgeStep step;
    bool is_ambiguous;  ///< see isAmbiguous()
  };

  bool hasNext() const { return place_ + 1 < samples_.size(); }
  const EdgeSample& older() const { return *samples_[place_]; }
  const EdgeSample& newer() const { return *samples_[place_ + 1]; }
  /// True if at() has to give what the library does, and that is not what the formula here does.
  bool isLibraryOther() const { return is_library_ && isAmbiguous(); }
  const Motion& motion() const;
  double partOf(std::int64_t duration) const;

  std::vector<const EdgeSample*> samples_;
  std::size_t place_ = 0;                 ///< of the older one
  mutable std::optional<Motion> motion_;  ///< there; nothing until it is asked for
  bool is_library_ = false;
};

}  // namespace link_bounds
