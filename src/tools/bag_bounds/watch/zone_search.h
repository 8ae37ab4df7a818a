// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the box of a body met a zone between two messages.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tools/bag_bounds/watch/body_motions.h"

namespace link_bounds {

/// Motions that are known no better than this stay undecided [ns].
constexpr std::int64_t kTimeResolution = 1'000;

/// Of pathBetween(): a motion is one however far apart its stamps are.
constexpr double kNoTimeout = 0;

/// What is proven is at most so far from the nearest pose that was looked at [m], where that is
/// farther away.
constexpr double kZoneAccuracy = 1e-3;

struct ZoneSearch {
  /// Proven: no box on the way is nearer [m]; not above the distances at its ends.
  double clearance = std::numeric_limits<double>::infinity();
  double nearest = std::numeric_limits<double>::infinity();  ///< of the poses that were tried
  std::int64_t nearest_stamp = 0;
  /// A change of sides: it was on the other side at `before` and is on this one at `after`.
  struct Crossing {
    bool is_entry;
    std::int64_t before;
    std::int64_t after;
  };
  std::vector<Crossing> crossings;  ///< in the order of time
  std::string undecided;            ///< why it is not known whether there are more; "" if it is
};

/// Of a body outside of the zone at both ends. Where the clearance is above `wanted`, it is not
/// refined. Such a search is expensive: BodyMotion::way decides most motions.
ZoneSearch searchZone(const TransformBuffer& tf, const BodyMotion& motion, const Aabb& zone,
                      double wanted, const std::function<bool()>& gives_up);

/// A search that found nothing, for the reason `why`.
ZoneSearch undecidedZone(const std::string& why);

}  // namespace link_bounds
