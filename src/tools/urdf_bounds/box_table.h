// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of a robot as text: a table to read, CSV or JSON.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "tools/text/table_text.h"

namespace link_bounds {

/// The three pairs of vectors (a, b) of the paper's Figure 3.
enum class Representation { kMinMax, kMinWidth, kCenterRadius };

/// All lengths in metres, along the axes of `frame`.
struct BoxTable {
  using NamedBox = std::pair<std::string, Aabb>;

  std::string frame;
  std::vector<NamedBox> boxes;
  std::vector<NamedBox> groups;
  Reasons incomplete;
};

/// JSON is always min-max.
void writeBoxes(const BoxTable& table, Format format, Representation representation,
                std::ostream& out);

}  // namespace link_bounds
