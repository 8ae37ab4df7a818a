// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What is printed of a bag: a table to read, CSV or JSON.
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

/// Times are nanoseconds of record time.
struct BagReport {
  std::string frame;       ///< the fixed frame
  std::int64_t begin = 0;  ///< of the first message; other times are printed from here on
  std::int64_t from = 0;   ///< the report covers from here ...
  std::int64_t to = 0;     ///< ... to here
  std::uint64_t messages = 0;
  std::vector<BoxRecord> boxes;
  std::optional<std::int64_t> at;  ///< of the next ones
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

/// Why it never had a box, and what to do.
std::string withRemedy(const BoxRecord& box);

/// What is incomplete, and why.
Reasons incompleteOf(const BagReport& report);

void write(const BagReport& report, Format format, std::ostream& out);

void writeJson(const BagReport& report, std::ostream& out);

/// The members of an object, on one line: the least covered link, the nearest pair, entries of
/// zones, what is incomplete.
std::string summaryJson(const BagReport& report);

}  // namespace link_bounds
