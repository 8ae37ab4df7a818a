// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What rows of joint values come to, as text: a table to read, CSV or JSON.
#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "tools/formats/table_text.h"

namespace link_bounds {

/// Where two links were nearest.
struct NearestRow {
  double distance;           ///< proven [m]; 0: contact
  double distance_max;       ///< [m]
  std::size_t row;           ///< index; the first one of that distance
  std::size_t contacts = 0;  ///< rows in which they were in contact
};

/// Rows are given by their index; what is printed counts from 1.
struct RowsTable {
  std::string frame;
  std::size_t count = 0;             ///< of all rows
  std::size_t left_out = 0;          ///< rows that nobody looked at; all else is of the others
  std::vector<double> times;         ///< of rows [s]; may be empty
  std::optional<double> limit;       ///< of distances [m]; none: there are none
  std::size_t with_contact = 0;      ///< rows
  std::optional<std::size_t> first;  ///< row with a contact
  std::optional<std::size_t> worst;  ///< row of the smallest distance
  std::vector<std::string> links;    ///< names
  std::vector<Aabb> boxes;           ///< of links, around these rows; empty without one
  std::map<std::pair<std::size_t, std::size_t>, NearestRow> pairs;  ///< links that were near
  Reasons incomplete;
};

void write(const RowsTable& table, Format format, std::ostream& out);

}  // namespace link_bounds
