// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Open questions are also reported when the exit code is that of a finding.
#include "tools/command_line/outcome.h"

#include "text/joined.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"

namespace link_bounds {
namespace {

constexpr int kLostGeometry = 2;

bool isCode(int code) {
  return code >= 0 && code <= kOpen;
}

void warnOfOpen(const std::vector<std::string>& open, const std::string& more = "") {
  warn("not everything was answered: " + joined(open, "; ") + more);
}

}  // namespace

void Outcome::addOpen(const std::string& what, std::size_t count) {
  if (count > 0) open.push_back(what + ": " + std::to_string(count));
}

int exitCode(const Outcome& outcome, const Demand& demand) {
  if (outcome.is_unusable) return kUnusable;
  const bool is_accepted = demand.allow_incomplete && !isInterrupted();
  const bool is_open = !outcome.open.empty() && !is_accepted;
  if (is_open)
    warnOfOpen(outcome.open,
               outcome.has_finding || isInterrupted() ? "" : "; --allow-incomplete accepts that");
  if (outcome.has_finding) return kFinding;
  if (is_open) return kOpen;
  return outcome.lost_geometry && demand.strict ? kLostGeometry : 0;
}

int worseCode(int first, int second) {
  if (!isCode(first) || !isCode(second)) return kUnusable;
  for (const int code : {kUnusable, kFinding, kOpen, kLostGeometry})
    if (first == code || second == code) return code;
  return 0;
}

const char* verdictOf(int exit_code) {
  switch (exit_code) {
    case 0:
      return "CLEAR";
    case kLostGeometry:
      return "LOST_GEOMETRY";
    case kFinding:
      return "FOUND";
    case kOpen:
      return "INCOMPLETE";
    default:
      return "UNUSABLE";
  }
}

}  // namespace link_bounds
