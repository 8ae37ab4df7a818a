// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A link as every search with it needs it.
#pragma once

#include <memory>
#include <vector>

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

/// The hull of each shape, or that of all.
std::vector<const PairHull*> partsOf(const PairBody& body);

}  // namespace link_bounds
