// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// The former place of link_bounds/geometry/mesh/triangle_mesh.h; goes with the next version.
#pragma once

#include "link_bounds/geometry/mesh/triangle_mesh.h"
