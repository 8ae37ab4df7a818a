// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The distances of near links as text: a table to read, CSV or JSON.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "link_bounds/geometry/distance/body_distance.h"
#include "tools/formats/table_text.h"

namespace link_bounds {

struct LinkDistance {
  std::string first;
  std::string second;
  BodyDistance distance;
};

struct DistanceTable {
  double limit = 0;                 ///< max distance of a listed pair [m]
  std::vector<LinkDistance> pairs;  ///< in the order of the links
  Reasons incomplete;               ///< links without distances
  bool has_compared = false;        ///< any two links were compared
};

/// How many pairs have distances that are less accurate than DistanceGoal asks for.
std::size_t roughPairs(const DistanceTable& distances);

/// Whether the bounds of a distance are farther apart than DistanceGoal asks for.
bool isRough(double lower, double upper);

/// The first line of CSV, and the line of a pair.
void writeCsvHead(std::ostream& out);
std::string csvLine(const LinkDistance& pair);

/// For people.
void writeTable(const DistanceTable& distances, std::ostream& out);

void writeCsv(const DistanceTable& distances, std::ostream& out);

/// A JSON array.
std::string toJson(const DistanceTable& distances);

}  // namespace link_bounds
