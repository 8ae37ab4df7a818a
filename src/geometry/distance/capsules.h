// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Balls and capsules. A URDF can only write a capsule as a cylinder and two balls.
#pragma once

#include <memory>

#include "link_bounds/geometry/distance/body.h"

namespace link_bounds {

/// The same body for searches at rigid poses. Each cylinder and two balls that form a capsule
/// become one shape: a segment that a ball sweeps. Each ball and each capsule has as its triangles
/// the centre or the segment alone: its tree has no solid. The bodies may differ by 64u of the
/// largest coordinate of the shapes, where u = 2^-53. Returns the body itself if it has no ball, or
/// more than 64 shapes.
std::shared_ptr<const Body> withCores(std::shared_ptr<const Body> body);

/// True for a ball or capsule whose triangles are its centre or segment, as withCores() makes them.
bool hasCore(const BodyShape& shape);

}  // namespace link_bounds
