// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Named boxes that should stay free.
#pragma once

#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

struct Zone {
  std::string name;
  std::string frame;  ///< tf name; "": the fixed frame
  Aabb box;           ///< with the axes of that frame
};

/// The zones of a YAML text: a map from names to boxes, or a list of boxes with names. `file` is
/// for messages. Throws UsageError that names file, zone, field and remedy.
std::vector<Zone> parseZones(const std::string& text, const std::string& file);

}  // namespace link_bounds
