// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What --each prints of one bag, and how --merge and --resume read it; doc/tools.md has the keys.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/bag_bounds/run/bag_run.h"

namespace link_bounds {

/// By which a bag is recognised.
struct BagIdentity {
  std::string name;                   ///< as it was given
  std::optional<std::uint64_t> size;  ///< [bytes]; none: it cannot be read
  std::string head;                   ///< fingerprint of its first 64 KiB; "": it cannot be read
};

BagIdentity identityOf(const std::string& bag);

/// Whether the one may be an unfinished copy of the other one.
bool isBeginOf(const BagIdentity& begin, const BagIdentity& whole);

/// A line, with its line break.
struct BagLine {
  std::string text;
  int exit_code;      ///< of its verdict, which says INCOMPLETE also with --allow-incomplete
  int complete_code;  ///< with --allow-incomplete

  int exitCode(const Demand& demand) const {
    return demand.allow_incomplete ? complete_code : exit_code;
  }
};

/// `question` is BagQuestion::fingerprint(), here and below.
BagLine lineOf(const BagIdentity& bag, const std::string& question, const BagRun& run,
               const Demand& demand);

/// The line of a bag about which nothing can be said.
BagLine unusableLine(const BagIdentity& bag, const std::string& question,
                     const std::string& reason);

/// As above; the reason may be another one in a further run.
BagLine diedLine(const BagIdentity& bag, const std::string& question, const std::string& reason);

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
  int complete_code = 0;                                   ///< with --allow-incomplete
  std::optional<std::pair<std::string, double>> coverage;  ///< the least covered link, its share
  std::optional<PairOfLine> worst;
  std::vector<ZoneOfLine> zones;
  std::string left_out;  ///< as in the line; "" of a bag about which nothing can be said
  std::string reason;    ///< why it is not clear, beside a finding; "" if there is nothing to say

  bool hasDied() const { return verdict == "DIED"; }
};

/// Bags by name; of several lines of one bag in a file the last one counts.
struct LineFile {
  struct Cut {
    std::string place;  ///< file and number
    std::string name;   ///< of the bag, as JSON; "" if it was cut before its end
  };

  std::map<std::string, ReadLine> lines;
  std::vector<Cut> cut;  ///< lines that were cut
  std::string two_bags;  ///< a name that two bags may have, and the remedy; "" if there is none
};

/// Where the lines that were cut are, of bags that have no whole line in any of the files.
std::vector<std::string> placesOfCut(const std::vector<LineFile>& files);

/// Throws UsageError if the file cannot be read, or is none that --each has written.
LineFile readLines(const std::string& file);

}  // namespace link_bounds
