// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Verdicts about the segments of a path as text: a table to read, CSV or JSON.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "robot/posed/path_prover.h"
#include "tools/formats/table_text.h"

namespace link_bounds {

struct PathSegment {
  std::size_t from;  ///< row, from 1
  std::size_t to;
  SegmentProof proof;
  std::vector<std::pair<std::string, double>> pose;  ///< joints that can be set, at proof.share
};

struct PathTable {
  double clearance = 0;             ///< bodies that are as near collide [m]
  std::vector<std::string> bodies;  ///< names
  std::vector<PathSegment> segments;
  Reasons incomplete;
};

void write(const PathTable& table, Format format, std::ostream& out);

}  // namespace link_bounds
