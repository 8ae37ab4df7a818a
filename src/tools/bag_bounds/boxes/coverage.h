// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long each link had a box, and what to do about links that had none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/bag_bounds/scene/edge_begins.h"
#include "world/bodies/scene.h"

namespace link_bounds {

/// The share of time in which each link had a box, from the first to the last transform of its own
/// frame. A static frame counts to the end: from the first transform of any link on, even if it was
/// recorded late, or below a moving frame from the first transform of that frame on. A frame at the
/// top of the tree counts from its own first transform to the end.
class Coverage {
 public:
  /// Call it at the record time `now` [ns]: with each tick that is reported, when a box of a link
  /// appears or disappears, and at the end. To call it for each transform would take a tenth of the
  /// time of a run.
  void sample(const Scene& scene, const TransformBuffer& tf, std::int64_t now);

  /// One per link, 0 to 1; a link that never had a transform is covered if it has a box.
  std::vector<double> shares() const;

  /// Call it when the clock jumps back to the time `to` [ns]: tf forgets the time before.
  void jumpBack(std::int64_t to);

  /// One per link [ns]: how long tf could have known its pose before its first box came. The max if
  /// there are several first boxes, because the clock jumped.
  std::vector<std::int64_t> delays() const;

 private:
  struct Link {
    bool has_begun = false;
    std::int64_t begin = 0;         ///< time of its first transform [ns]
    std::int64_t since = 0;         ///< counted from here on: `begin`, or earlier if static [ns]
    std::int64_t delay = 0;         ///< see delays()
    bool had_box = false;           ///< since the begin, or since the last jump
    bool has_box = false;           ///< at the last sample
    std::int64_t time = 0;          ///< counted up to the last transform [ns]
    std::int64_t covered = 0;       ///< part of `time` with a box [ns]
    std::int64_t open_time = 0;     ///< time since the last transform [ns]
    std::int64_t open_covered = 0;  ///< part of `open_time` with a box [ns]
  };

  void add(Link& link, TransformBuffer::Frame frame, const Scene& scene, const TransformBuffer& tf,
           std::int64_t now);
  void lookForBox(Link& link, TransformBuffer::Frame frame, const Scene& scene,
                  const TransformBuffer& tf, std::int64_t now);
  std::int64_t carrierTime(TransformBuffer::Frame frame, const Scene& scene,
                           const TransformBuffer& tf, std::int64_t now) const;

  std::vector<Link> links_;
  EdgeBegins begins_;
  std::int64_t last_ = 0;      ///< time of the last sample [ns]
  std::uint64_t version_ = 0;  ///< of tf at the last sample
};

/// Why tf may lack the frame of link `i`, which has no box, and an option to add; "" if unknown.
std::string frameRemedy(std::size_t i, const Scene& scene, const TransformBuffer& tf);

/// An option to add if the first box of link `i` came late; "" if none helps. `bag` is the bag with
/// the transforms.
std::string lateRemedy(std::size_t i, const std::string& bag, const Scene& scene,
                       const TransformBuffer& tf);

}  // namespace link_bounds
