// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Proofs first, then the comparison with the SRDF.
#include "tools/urdf_bounds/pairs_report.h"

#include <chrono>
#include <iostream>

#include "link_bounds/robot/urdf/overlap_filter.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"
#include "tools/command_line/text_file.h"
#include "tools/urdf_bounds/pairs_table.h"

namespace link_bounds {
namespace {

/// Ends when the budget is used up, or at Ctrl-C.
ProofControl controlFor(const UrdfBoundsOptions& options) {
  const std::chrono::duration<double> budget(options.budget.value_or(kDefaultBudget));
  const auto start = std::chrono::steady_clock::now();
  ProofControl control;
  control.is_over = [start, budget] {
    return isInterrupted() || std::chrono::steady_clock::now() - start >= budget;
  };
  if (hasTerminal()) {
    control.progress = [](std::size_t decided, std::size_t total) {
      drawBar(decided, total, "pairs");
    };
  }
  return control;
}

std::vector<DisabledPair> adjacentPairs(const Robot& robot, const BoundedRobot& bounded) {
  const RigidBodies rigid = rigidBodies(robot);
  std::vector<DisabledPair> pairs;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    for (std::size_t j = i + 1; j < bounded.links.size(); ++j) {
      if (areJoined(rigid, bounded.indices[i], bounded.indices[j]))
        pairs.push_back({bounded.links[i].name, bounded.links[j].name, "Adjacent"});
    }
  }
  return pairs;
}

/// The search ended before the clearance was as accurate as it should be.
bool isRough(const PairProof& proof, const PairGoal& goal) {
  constexpr double kRounding = 1e-9;  // m
  return proof.nearest - proof.clearance > goal.accuracy + kRounding;
}

SrdfCheck checkSrdf(const std::string& file, const std::vector<DisabledPair>& disabled,
                    const std::vector<PairRow>& rows) {
  std::vector<NamePair> names;
  for (const DisabledPair& pair : disabled)
    names.emplace_back(pair.first, pair.second);
  const NamePairs exempt(names);
  SrdfCheck check{file, {}, {}, {}};
  for (const PairRow& row : rows) {
    const bool is_exempt = exempt.contains(row.first, row.second);
    const Verdict verdict = row.proof.verdict;
    const bool should_be = verdict == Verdict::kNever || verdict == Verdict::kAlways;
    if (is_exempt && verdict == Verdict::kSometimes) check.wrong.push_back(&row);
    if (is_exempt && verdict == Verdict::kUndecided) check.undecided.push_back(&row);
    if (!is_exempt && should_be) check.forgotten.push_back(&row);
  }
  return check;
}

Outcome outcomeOf(const PairsTable& table, const PairGoal& goal) {
  std::size_t undecided = 0;
  std::size_t rough = 0;
  for (const PairRow& row : table.rows) {
    const PairProof& proof = row.proof;
    if (proof.verdict == Verdict::kUndecided) ++undecided;
    if (proof.verdict == Verdict::kNever && isRough(proof, goal)) ++rough;
  }
  Outcome outcome;
  outcome.has_finding = table.srdf && !table.srdf->wrong.empty();
  outcome.lost_geometry = !table.incomplete.empty();
  outcome.addOpen("incomplete names", table.incomplete.size());
  outcome.addOpen("UNDECIDED pairs", undecided);
  outcome.addOpen("clearances that did not reach --accuracy", rough);
  return outcome;
}

void write(const PairsTable& table, const UrdfBoundsOptions& options) {
  if (options.as_srdf) {
    writeSrdf(table, std::cout);
  } else if (options.format == Format::kJson) {
    return writeJson(table, std::cout);
  } else if (options.format == Format::kCsv) {
    writeCsv(table, std::cout);
  } else {
    return writeTable(table, std::cout);
  }
  if (table.srdf) writeCheck(*table.srdf, std::cerr);
}

}  // namespace

Outcome writePairs(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges) {
  std::vector<DisabledPair> disabled;
  if (options.srdf) disabled = parseSrdf(readText(*options.srdf, "a SRDF"), robot, *options.srdf);
  PairsTable table;
  table.clearance = options.clearance.value_or(0);
  const PairGoal goal{table.clearance, options.accuracy.value_or(kDefaultAccuracy)};
  for (PairProof& proof : provePairs(robot, bounded, ranges, goal, controlFor(options))) {
    table.rows.push_back(
        {bounded.links[proof.first].name, bounded.links[proof.second].name, std::move(proof)});
  }
  if (hasTerminal()) eraseBar();
  table.adjacent = adjacentPairs(robot, bounded);
  for (const BoundedLink& link : bounded.links) {
    if (!link.isWhole()) table.incomplete.emplace_back(link.name, link.missing);
  }
  if (options.srdf) table.srdf = checkSrdf(*options.srdf, disabled, table.rows);
  for (const auto& [reason, count] : reasonsOf(table))
    warn(std::to_string(count) + (count == 1 ? " pair is" : " pairs are") +
         " not decided: " + reason);
  write(table, options);
  return outcomeOf(table, goal);
}

}  // namespace link_bounds
