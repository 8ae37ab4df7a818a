// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes of a marker's content the body whose distances are computed.
#pragma once

#include <memory>

#include "world/moment/triangle_trees.h"

namespace link_bounds {

/// Whether the body has triangles, segments or points, which are held in a tree. Otherwise it
/// consists of solids.
bool hasTree(const ObjectContent& content);

/// The tree of the triangles, segments or points of a list, not of a mesh. `check_interrupt` may
/// throw to abort it.
MadeTree listTree(const ObjectContent& content, const CheckInterrupt& check_interrupt = nullptr);

/// `triangles` may be null.
Body objectBody(const ObjectContent& content, std::shared_ptr<const TriangleTree> triangles);

}  // namespace link_bounds
