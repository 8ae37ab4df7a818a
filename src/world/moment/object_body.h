// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From what a marker draws to the body whose distance is computed.
#pragma once

#include <memory>

#include "world/moment/triangle_trees.h"

namespace link_bounds {

/// Whether the body has triangles, segments or points that a tree can hold; else it is made of
/// solids.
bool hasTree(const ObjectContent& content);

/// The tree of the triangles, segments or points of a list. Not for a mesh. What `check_interrupt`
/// throws ends it.
MadeTree listTree(const ObjectContent& content, const CheckInterrupt& check_interrupt = nullptr);

/// `triangles` may be null.
Body objectBody(const ObjectContent& content, std::shared_ptr<const TriangleTree> triangles);

}  // namespace link_bounds
