// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a run came to, as an exit code: one rule for all programs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace link_bounds {

/// The exit code of unusable input or arguments.
constexpr int kUnusable = 1;

/// Something was found, see Outcome::has_finding.
constexpr int kFinding = 3;

/// Something was not answered, see Outcome::open.
constexpr int kOpen = 4;

/// What is open where there was no pair, none but of adjacent links, or no box.
constexpr char kNothingCompared[] = "no two bodies were compared";
constexpr char kNoPairExamined[] = "no pair was examined";
constexpr char kNoLinkBounded[] = "no link has a box";

struct Outcome {
  bool is_unusable = false;       ///< the input allows no answer
  bool has_finding = false;       ///< an entry, a distance undercut, an exemption that is wrong
  std::vector<std::string> open;  ///< what was not decided, loaded, seen, reached or looked at
  bool lost_geometry = false;     ///< any geometry could not be used

  /// Adds such as "pairs not decided: 2" to what is open, unless `count` is 0.
  void addOpen(const std::string& what, std::size_t count);
};

/// Options of the user.
struct Demand {
  bool strict = false;            ///< lost geometry is a failure
  bool allow_incomplete = false;  ///< what is open does not count, unless Ctrl-C ended the run
};

/// 1 unusable, 3 a finding, 4 something is open, 2 lost geometry, 0 all was answered and holds: the
/// first that applies. Warns of what is open, unless that is accepted.
int exitCode(const Outcome& outcome, const Demand& demand);

/// Of the exit codes of two runs, the one that comes first in that order; 1 if one is no exit code.
int worseCode(int first, int second);

/// Such as "CLEAR" for 0.
const char* verdictOf(int exit_code);

}  // namespace link_bounds
