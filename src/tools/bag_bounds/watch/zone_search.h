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

/// Time intervals shorter than this are not halved any more: their motion stays undecided [ns].
constexpr std::int64_t kTimeResolution = 1'000;

/// Timeout of pathBetween(): none, so the stamps of a motion may be any time apart.
constexpr double kNoTimeout = 0;

/// Max gap between the proven clearance and the nearest pose that was examined, if that pose is
/// farther away than this [m].
constexpr double kZoneAccuracy = 1e-3;

struct ZoneSearch {
  /// Proven: no box on the way is nearer to the zone [m]. Never above the distances at both ends.
  double clearance = std::numeric_limits<double>::infinity();
  double nearest = std::numeric_limits<double>::infinity();  ///< of the poses that were tried
  std::int64_t nearest_stamp = 0;
  /// The body enters or leaves the zone between the stamps `before` and `after` [ns].
  struct Crossing {
    bool is_entry;
    std::int64_t before;
    std::int64_t after;
  };
  std::vector<Crossing> crossings;  ///< in the order of time
  std::string undecided;            ///< why there may be more of them; "" if there are not
};

/// The body must be outside of the zone at the begin of the motion. Clearances above `wanted` [m]
/// are not refined. The search is expensive: BodyMotion::way decides most motions without it.
ZoneSearch searchZone(const TransformBuffer& tf, const BodyMotion& motion, const Aabb& zone,
                      double wanted, const std::function<bool()>& gives_up);

/// A search that found nothing, for the reason `why`.
ZoneSearch undecidedZone(const std::string& why);

}  // namespace link_bounds
