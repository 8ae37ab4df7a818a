// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A link with the data that every search needs, and points that prove that two links touch.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "link_bounds/geometry/distance/body_distance.h"
#include "robot/pairs/body_cloud.h"

namespace link_bounds {

/// The convex hull of a body or of one of its shapes.
struct PairHull {
  std::shared_ptr<const Body> body;  ///< without triangles
  BodyCloud cloud;
};

/// A solid without its skin: a ball of radius `skin` around each point of `body` lies in the solid.
struct SolidCore {
  Body body;
  double skin;  ///< m
};

struct PairBody {
  std::shared_ptr<const Body> body;
  PairHull hull;
  std::vector<PairHull> parts;  ///< of each shape; empty if there is one shape, or too many
  std::vector<SolidCore> cores;
};

PairBody pairBody(const Body& body);

/// The hulls of the single shapes if there are any, else the hull of the body.
std::vector<const PairHull*> partsOf(const PairBody& body);

/// A point of a core of one body and a point of the other body whose distance is at most
/// `max_distance` [m] plus the skin of that core. In the frame of the first body; nothing if there
/// are no such points.
std::optional<BodyDistance> coreContact(const PairBody& first, const PairBody& second,
                                        const Eigen::Affine3d& first_from_second,
                                        double max_distance);

}  // namespace link_bounds
