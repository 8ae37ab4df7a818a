// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The report about the bags: a table to read, CSV or JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tools/bag_bounds/boxes/box_records.h"
#include "tools/bag_bounds/boxes/boxes_at.h"
#include "tools/bag_bounds/watch/nearest_pairs.h"
#include "tools/bag_bounds/watch/zone_watch.h"
#include "tools/formats/table_text.h"

namespace link_bounds {

/// Times are record times [ns].
struct BagReport {
  std::string frame;       ///< the fixed frame
  std::int64_t begin = 0;  ///< time of the first message; printed times count from it
  std::int64_t from = 0;   ///< the report covers from here ...
  std::int64_t to = 0;     ///< ... to here
  std::uint64_t messages = 0;
  std::vector<BoxRecord> boxes;
  std::optional<std::int64_t> at;  ///< time of `boxes_at`
  std::vector<BoxAt> boxes_at;
  std::vector<ZoneRecord> zones;
  std::optional<std::vector<NearestPair>> distances;
  double distance_limit = 0;  ///< [m]
  bool has_compared = false;  ///< any two bodies, if there are distances
  double min_coverage = 0;    ///< see Coverage
  std::vector<std::string> losses;
  std::string left_out;           ///< links that have only geometry of the other kind, in words
  std::vector<std::string> open;  ///< as Outcome::open, for JSON
};

/// Why a box is missing or came late, and what to do.
std::string withRemedy(const BoxRecord& box);

/// The names that are incomplete, and why.
Reasons incompleteOf(const BagReport& report);

void write(const BagReport& report, Format format, std::ostream& out);

void writeJson(const BagReport& report, std::ostream& out);

/// Members of a JSON object, on one line: the link or object with the min coverage, the nearest
/// pair, entries into zones, and what is incomplete.
std::string summaryJson(const BagReport& report);

}  // namespace link_bounds
