// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the line of --each about one bag, and reads it for --merge and --resume. doc/tools.md has
// the keys.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/bag_bounds/run/bag_run.h"

namespace link_bounds {

/// Identifies a bag.
struct BagIdentity {
  std::string name;                   ///< as it was given
  std::optional<std::uint64_t> size;  ///< [bytes]; none: it cannot be read
  std::string head;                   ///< fingerprint of its first 64 KiB; "": it cannot be read
};

BagIdentity identityOf(const std::string& bag);

/// Whether `begin` may be an unfinished copy of `whole`.
bool isBeginOf(const BagIdentity& begin, const BagIdentity& whole);

/// A line, with its line break.
struct BagLine {
  std::string text;
  int exit_code;      ///< without --allow-incomplete, as the verdict of the line
  int complete_code;  ///< with --allow-incomplete

  int exitCode(const Demand& demand) const {
    return demand.allow_incomplete ? complete_code : exit_code;
  }
};

/// `question` is BagQuestion::fingerprint(), here and below.
BagLine lineOf(const BagIdentity& bag, const std::string& question, const BagRun& run,
               const Demand& demand);

/// The line of a bag that could not be evaluated.
BagLine unusableLine(const BagIdentity& bag, const std::string& question,
                     const std::string& reason);

/// The line of a bag whose process died; another run may end differently.
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

/// The parts of a line that --merge and --resume need.
struct ReadLine {
  std::string text;  ///< without its line break
  std::string file;  ///< where it was read
  BagIdentity bag;
  std::string question;
  std::string verdict;
  int exit_code = 0;
  int complete_code = 0;  ///< with --allow-incomplete
  std::optional<std::pair<std::string, double>>
      coverage;  ///< name and share (0..1) of the min coverage
  std::optional<PairOfLine> worst;
  std::vector<ZoneOfLine> zones;
  std::string left_out;  ///< as in the line; "" if the bag was not evaluated
  std::string reason;    ///< why the verdict is not CLEAR, apart from findings; "" if none

  bool hasDied() const { return verdict == "DIED"; }
};

/// The lines of one file by name of the bag. If a bag has several lines, the last one counts.
struct LineFile {
  struct Cut {
    std::string place;  ///< file and number
    std::string name;   ///< of the bag, as JSON; "" if it was cut before its end
  };

  std::map<std::string, ReadLine> lines;
  std::vector<Cut> cut;  ///< lines that were cut
  std::string two_bags;  ///< a name that two bags may have, and the remedy; "" if there is none
};

/// The places of cut lines whose bags have no whole line in any of the files.
std::vector<std::string> placesOfCut(const std::vector<LineFile>& files);

/// Throws UsageError if the file cannot be read, or is none that --each has written.
LineFile readLines(const std::string& file);

}  // namespace link_bounds
