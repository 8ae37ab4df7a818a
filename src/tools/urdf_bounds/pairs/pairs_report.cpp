// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which links can collide: proofs first, then the comparison with the SRDF, and the file of
// --certificate, which doc/tools.md describes.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <utility>

#include "robot/pairs/pair_certificate.h"
#include "robot/pairs/pair_proofs.h"
#include "tools/command_line/interrupt.h"
#include "tools/command_line/terminal.h"
#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/pairs/pairs_table.h"
#include "tools/urdf_bounds/poses/reports.h"
#include "tools/urdf_bounds/request/certificate_head.h"
#include "tools/urdf_bounds/request/input.h"

namespace link_bounds {
namespace {

/// Ends when the budget is used up, or at Ctrl-C.
ProofControl controlFor(const UrdfBoundsOptions& options) {
  ProofControl control;
  control.is_over = overAfter(options.budget.value_or(kDefaultBudget));
  if (hasTerminal()) {
    control.progress = [](std::size_t decided, std::size_t total) {
      drawBar(decided, total, "pairs");
    };
  }
  return control;
}

/// Whether the nearest pose exceeds the proven clearance by more than the goal's accuracy.
bool isRough(const PairProof& proof, const PairGoal& goal) {
  constexpr double kRounding = 1e-9;  // m
  return proof.nearest - proof.clearance > goal.accuracy + kRounding;
}

Outcome outcomeOf(const PairsTable& table, const PairGoal& goal) {
  std::size_t examined = 0;
  std::size_t undecided = 0;
  std::size_t rough = 0;
  for (const std::vector<PairProof>* proofs : {&table.rows, &table.rigid}) {
    for (const PairProof& proof : *proofs) {
      if (proof.verdict != Verdict::kAdjacent) ++examined;
      if (proof.verdict == Verdict::kUndecided) ++undecided;
      if (proof.verdict == Verdict::kNever && isRough(proof, goal)) ++rough;
    }
  }
  Outcome outcome;
  outcome.has_finding = table.srdf && !table.srdf->wrong.empty();
  outcome.lost_geometry = !table.incomplete.empty();
  if (examined == 0) outcome.open.emplace_back(kNoPairExamined);
  outcome.addOpen("incomplete names", table.incomplete.size());
  outcome.addOpen("UNDECIDED pairs", undecided);
  if (table.srdf) {
    const auto& exempt = table.srdf->undecided;
    const auto is_else = [](const PairProof* proof) {
      return proof->verdict != Verdict::kUndecided;
    };
    outcome.addOpen("exemptions whose reason is not proven",
                    static_cast<std::size_t>(std::count_if(exempt.begin(), exempt.end(), is_else)));
  }
  outcome.addOpen("clearances that did not reach --accuracy", rough);
  return outcome;
}

void write(const PairsTable& table, const UrdfBoundsOptions& options) {
  if (options.as_srdf) {
    writeSrdf(table, options.accept_sampled, std::cout);
    writeUndecided(table, std::cerr);
  } else if (options.format == Format::kJson) {
    return writeJson(table, std::cout);
  } else if (options.format == Format::kCsv) {
    writeCsv(table, std::cout);
  } else {
    return writeTable(table, std::cout);
  }
  if (table.srdf) writeCheck(*table.srdf, table.links, options.as_srdf, std::cerr);
}

/// A pair that cannot move has one pose, whose contact is measured with the tolerance kTouch.
PairClaim claimOf(const PairProof& proof, const UrdfBoundsOptions& options) {
  const double goal = options.clearance.value_or(0);
  if (proof.verdict == Verdict::kNever) return {false, goal + kClaimed * (proof.clearance - goal)};
  if (proof.verdict == Verdict::kTouching)
    return {true, std::max(goal, options.touching.value_or(kDefaultTouching))};
  return {true, proof.can_move ? goal : goal + PairGoal::kTouch};
}

bool isProven(Verdict verdict) {
  return verdict == Verdict::kNever || verdict == Verdict::kAlways || verdict == Verdict::kTouching;
}

/// Writes a proof for each pair that never collides, always collides or always touches. Returns the
/// number of such pairs without a proof: it would be too long, or `is_over` stopped it. `out` comes
/// from beginCertificate(). Throws UsageError if it cannot be written.
std::size_t writeCertificate(const UrdfBoundsOptions& options, const Robot& robot,
                             const BoundedRobot& bounded, const std::vector<JointRange>& ranges,
                             const std::vector<PairProof>& proofs,
                             const std::function<bool()>& is_over, std::ofstream& out) {
  std::vector<PairBody> bodies;
  for (const Body& body : bounded.bodies)
    bodies.push_back(pairBody(body));
  const auto name = [&](std::size_t joint) { return jsonString(robot.joints[joint].name); };
  /// Returns false and writes nothing if no tree proves the claim.
  const auto write_pair = [&](const PairProof& proof) {
    const PairClaim claim = claimOf(proof, options);
    PairCertificate pair(
        jointPath(robot, ranges, bounded.indices[proof.first], bounded.indices[proof.second]),
        bodies[proof.first], bodies[proof.second], claim);
    std::ostringstream tree;
    if (!pair.writeTree(is_over, tree)) return false;
    out << "{\"first\": " << jsonString(bounded.links[proof.first].name)
        << ", \"second\": " << jsonString(bounded.links[proof.second].name) << ", \"verdict\": \""
        << toText(proof.verdict) << "\", \"distance\": " << exactNumber(claim.distance)
        << ", \"variables\": [" << joined(pair.path().variables, ", ", name)
        << "], \"tree\": " << tree.str() << "}\n";
    return true;
  };
  std::map<Verdict, std::size_t> left_out;
  std::size_t covered = 0;
  for (const PairProof& proof : proofs) {
    const bool is_covered = isProven(proof.verdict) && write_pair(proof);
    ++(is_covered ? covered : left_out[proof.verdict]);
  }
  endCertificate(options, "pairs", covered, jsonCounts(left_out), out);
  return left_out[Verdict::kNever] + left_out[Verdict::kAlways] + left_out[Verdict::kTouching];
}

}  // namespace

Outcome writePairs(const UrdfBoundsOptions& options, const Robot& robot,
                   const BoundedRobot& bounded, const std::vector<JointRange>& ranges) {
  const Srdf old = readSrdf(options.srdf, robot);
  PairsTable table;
  table.clearance = options.clearance.value_or(0);
  for (const BoundedLink& link : bounded.links) {
    table.links.push_back(link.name);
    if (!link.isWhole()) table.incomplete.emplace_back(link.name, link.missing);
  }
  const PairGoal goal{table.clearance, options.accuracy.value_or(kDefaultAccuracy),
                      options.touching.value_or(kDefaultTouching)};
  std::ofstream certificate = beginCertificate("pairs", options, robot);
  const ProofControl control = controlFor(options);
  const PairChoice choice{options.adjacent, options.as_srdf};
  for (PairProof& proof : provePairs(robot, bounded, ranges, goal, control, choice))
    (proof.is_rigid ? table.rigid : table.rows).push_back(std::move(proof));
  if (hasTerminal()) eraseBar();
  if (options.srdf)
    table.srdf =
        checkedSrdf(*options.srdf, old.text, Exemptions(old.pairs), table.links, table.rows);
  for (const auto& [reason, count] : reasonsOf(table))
    warn(std::to_string(count) + (count == 1 ? " pair is" : " pairs are") +
         " not decided: " + reason);
  std::size_t uncertified = 0;
  if (options.certificate) {
    uncertified = writeCertificate(options, robot, bounded, ranges, table.rows,
                                   controlFor(options).is_over, certificate);
  }
  write(table, options);
  Outcome outcome = outcomeOf(table, goal);
  outcome.addOpen("proven pairs that are not in the certificate", uncertified);
  return outcome;
}

}  // namespace link_bounds
