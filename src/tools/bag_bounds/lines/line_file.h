// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of lines that --each has written.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/bag_bounds/lines/bag_line.h"

namespace link_bounds {

struct PairOfLine {
  std::string first;
  std::string second;
  double clearance = 0;  ///< proven for the whole bag [m]
  double distance = 0;   ///< [m]
  std::string time;      ///< s after the first message of the bag
};

struct ZoneOfLine {
  std::string name;
  std::uint64_t entries = 0;
};

/// What --merge and --resume need of a line.
struct ReadLine {
  std::string text;  ///< without its line break
  std::string file;  ///< where it was read
  BagIdentity bag;
  std::string question;
  std::string verdict;
  int exit_code = 0;
  std::optional<std::pair<std::string, double>> coverage;  ///< the least covered link, its share
  std::optional<PairOfLine> worst;
  std::vector<ZoneOfLine> zones;
  std::string reason;  ///< why it is not clear; "" if it is, or if a finding says so

  bool hasDied() const { return verdict == "DIED"; }
};

/// Bags by name; of several lines of one bag in a file the last one counts.
struct LineFile {
  std::map<std::string, ReadLine> lines;
  /// Lines that were cut, of bags that have no whole line: file and number.
  std::vector<std::string> cut;
};

/// Throws UsageError if the file cannot be read, or is none that --each has written.
LineFile readLines(const std::string& file);

}  // namespace link_bounds
