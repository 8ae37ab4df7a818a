// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The summary of rows of joint values as text: a table to read, CSV or JSON.
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

/// The row in which two links were nearest.
struct NearestRow {
  double distance;           ///< proven lower bound [m]; 0: contact
  double distance_max;       ///< [m]
  std::size_t row;           ///< index; the first row with that distance
  std::size_t contacts = 0;  ///< rows in which they were in contact
};

/// Rows are indices from 0; printed numbers count from 1.
struct RowsTable {
  std::string frame;
  std::size_t count = 0;             ///< number of all rows
  std::size_t left_out = 0;          ///< number of rows that were not examined
  std::vector<double> times;         ///< by row [s]; may be empty
  std::optional<double> limit;       ///< max distance [m]; none: no distances are given
  std::size_t with_contact = 0;      ///< number of rows with a contact
  std::optional<std::size_t> first;  ///< first row with a contact
  std::optional<std::size_t> worst;  ///< row of the smallest distance
  std::vector<std::string> links;    ///< names
  std::vector<Aabb> boxes;           ///< by link, around all examined rows; may be empty
  std::map<std::pair<std::size_t, std::size_t>, NearestRow> pairs;  ///< links that were near
  Reasons incomplete;
};

void write(const RowsTable& table, Format format, std::ostream& out);

}  // namespace link_bounds
