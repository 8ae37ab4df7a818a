// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a user of the node can do about a mesh that cannot be used.
#pragma once

#include <string>

#include "link_bounds/robot/mesh/mesh_fault.h"

namespace link_bounds {

/// Like plainRemedy(), but names a parameter or ~reload where one of them helps.
std::string nodeRemedy(MeshFault fault);

}  // namespace link_bounds
