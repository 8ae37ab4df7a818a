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

/// Of each link, the share of the time between its first and its last transform in which it had a
/// box. Transforms of a link are those of its own frame. A static one is there from the first one
/// of any link to the end, also where it was recorded late, a frame at the top of the tree from its
/// own first one; on a frame that moves, it is there from the first transform of that frame.
class Coverage {
 public:
  /// To be called with each tick that is reported, when a box of a link comes or goes, and at the
  /// end [record time, ns]. A look at each transform would take a tenth of the time of a run.
  void sample(const Scene& scene, const TransformBuffer& tf, std::int64_t now);

  /// One per link, 0 to 1; a link that never had a transform counts as covered where it has a box.
  std::vector<double> shares() const;

  /// The clock jumps back: tf forgets the time before.
  void jumpBack(std::int64_t to);

  /// One per link: for how long tf could have told where it was, before its first box came, or the
  /// first one after a jump of the clock, if that is longer [ns].
  std::vector<std::int64_t> delays() const;

 private:
  struct Link {
    bool has_begun = false;
    std::int64_t begin = 0;      ///< time of that [ns]
    std::int64_t since = 0;      ///< from then on it counts: that, or earlier if it is static [ns]
    std::int64_t delay = 0;      ///< see delays()
    bool had_box = false;        ///< since the begin, or since the last jump
    bool has_box = false;        ///< at the last sample
    std::int64_t time = 0;       ///< to the last transform [ns]
    std::int64_t covered = 0;    ///< of that [ns]
    std::int64_t open_time = 0;  ///< since the last transform [ns]
    std::int64_t open_covered = 0;  ///< of that [ns]
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

/// Why tf may lack the frame of link `i`, which has no box, as an option to add; "" if unknown.
std::string frameRemedy(std::size_t i, const Scene& scene, const TransformBuffer& tf);

/// An option to add where the first box of link `i` came late, of which `bag` has the transforms;
/// "" if none helps.
std::string lateRemedy(std::size_t i, const std::string& bag, const Scene& scene,
                       const TransformBuffer& tf);

}  // namespace link_bounds
