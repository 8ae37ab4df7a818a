// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Converts pairs of bodies to messages.
#pragma once

#include <vector>

#include "link_bounds/BoxOverlap.h"
#include "link_bounds/Distance.h"
#include "link_bounds/geometry/pairs/sweep_and_prune.h"
#include "world/moment/moment.h"
#include "world/moment/pair_heap.h"

namespace link_bounds {

Distance toMessage(const Moment& moment, const FoundPair& pair);

/// The distance of a message, without its names and stamp.
BodyDistance bodyDistanceOf(const Distance& message);

BoxOverlap toMessage(const Moment& moment, const BoxPair& pair);

/// The pair with the smallest lower bound. Without pairs, a distance of `limit` [m] without names:
/// no pair is nearer than that.
Distance nearestOf(const std::vector<Distance>& distances, double limit);

}  // namespace link_bounds
