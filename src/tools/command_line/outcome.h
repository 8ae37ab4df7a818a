// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The result of a run as an exit code: one rule for all programs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace link_bounds {

/// The exit code of unusable input or arguments.
constexpr int kUnusable = 1;

/// The exit code of a finding, see Outcome::has_finding.
constexpr int kFinding = 3;

/// The exit code of open questions, see Outcome::open.
constexpr int kOpen = 4;

/// Texts for Outcome::open: no pair at all, only pairs of adjacent links, or no box.
constexpr char kNothingCompared[] = "no two bodies were compared";
constexpr char kNoPairExamined[] = "no pair was examined";
constexpr char kNoLinkBounded[] = "no link has a box";

struct Outcome {
  bool is_unusable = false;       ///< the input allows no answer
  bool has_finding = false;       ///< a zone entry, a distance below its limit, a wrong exemption
  std::vector<std::string> open;  ///< one text per kind of question without an answer
  bool lost_geometry = false;     ///< some geometry could not be used

  /// Adds a text such as "pairs not decided: 2" to `open`, unless `count` is 0.
  void addOpen(const std::string& what, std::size_t count);
};

/// Options of the user.
struct Demand {
  bool strict = false;            ///< lost geometry is a failure
  bool allow_incomplete = false;  ///< open questions do not count, unless Ctrl-C ended the run
};

/// The first that applies: 1 unusable, 3 a finding, 4 open questions, 2 lost geometry if `strict`,
/// else 0. Warns of open questions, unless `allow_incomplete` accepts them.
int exitCode(const Outcome& outcome, const Demand& demand);

/// The exit code of two runs together, by the same order; 1 if one of them is no exit code.
int worseCode(int first, int second);

/// The word for an exit code, such as "CLEAR" for 0.
const char* verdictOf(int exit_code);

}  // namespace link_bounds
