// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// In the written SRDF, adjacent pairs come first, then the others in the order of the table.
#include "tools/urdf_bounds/pairs/pairs_srdf.h"

#include <cmath>
#include <set>

#include "tools/formats/safe_text.h"
#include "tools/urdf_bounds/pairs/pairs_table.h"

namespace link_bounds {
namespace {

constexpr const char* kReasons[kVerdictCount] = {"Never", "Always", "Always",  nullptr,
                                                 nullptr, nullptr,  "Adjacent"};

/// MoveIt's word for a pair that needs no check; null for others.
const char* reasonFor(Verdict verdict) {
  return kReasons[static_cast<std::size_t>(verdict)];
}

std::string metres(double value) {
  return shortNumber(value) + " m";
}

std::string whatIsKnown(const PairProof& proof) {
  if (!std::isfinite(proof.nearest)) return "no pose was tried";
  return "they are never nearer than " + metres(proof.clearance) + ", and " +
         metres(proof.nearest) + " apart at " + printable(argumentsOf(proof.pose));
}

/// Suggests reason="Always" for a pair that collided in all poses tried; "" for others.
std::string remedyFor(const PairProof& proof) {
  if (proof.verdict != Verdict::kContactSampled) return "";
  return ", as in " + inAllPoses(proof) + "; reason=\"Always\" says so";
}

/// Makes the lines of a SRDF from one table.
class SrdfWriter {
 public:
  SrdfWriter(const PairsTable& table, bool accept_sampled)
      : table_(table), accept_sampled_(accept_sampled) {}

  std::vector<SrdfLine> lines() const {
    std::vector<SrdfLine> lines;
    for (const bool is_adjacent : {true, false}) {
      for (const auto* proofs : {&table_.rows, &table_.rigid}) {
        for (const PairProof& proof : *proofs) {
          if ((proof.verdict == Verdict::kAdjacent) != is_adjacent) continue;
          SrdfLine line = lineOf(proof);
          if (line.pair || !line.comment.empty()) lines.push_back(std::move(line));
        }
      }
    }
    for (DisabledPair& pair : othersOfTheOldOne())
      lines.push_back({std::move(pair), ""});
    return lines;
  }

 private:
  SrdfLine lineOf(const PairProof& proof) const {
    const char* reason = reasonFor(proof.verdict);
    if (accept_sampled_ && proof.verdict == Verdict::kContactSampled) reason = "Always";
    if (reason) return {pairOf(proof, reason), commentOf(proof)};
    const std::string* old = oldReason(proof);
    if (!old || judged(proof, *old) == Exemption::kWrong) return {std::nullopt, commentOf(proof)};
    const bool is_open = judged(proof, *old) == Exemption::kUndecided;
    return {pairOf(proof, *old), is_open ? "not decided: " + names(proof) : commentOf(proof)};
  }

  std::string commentOf(const PairProof& proof) const {
    if (proof.verdict == Verdict::kUndecided) return "not decided: " + names(proof);
    if (proof.verdict != Verdict::kContactSampled) return "";
    return "not proven: " + names(proof) + " collided in " + inAllPoses(proof);
  }

  std::string names(const PairProof& proof) const { return namesOf(proof, table_.links); }

  DisabledPair pairOf(const PairProof& proof, const std::string& reason) const {
    return {table_.links[proof.first], table_.links[proof.second], reason};
  }

  const std::string* oldReason(const PairProof& proof) const {
    if (!table_.srdf) return nullptr;
    return table_.srdf->exempt.reasonOf(table_.links[proof.first], table_.links[proof.second]);
  }

  /// Pairs of the old SRDF that have no proof, because one of their links has no geometry.
  std::vector<DisabledPair> othersOfTheOldOne() const {
    std::vector<DisabledPair> others;
    if (!table_.srdf) return others;
    const std::set<std::string> links(table_.links.begin(), table_.links.end());
    for (DisabledPair& pair : table_.srdf->exempt.pairs()) {
      const bool is_known = links.count(pair.first) > 0 && links.count(pair.second) > 0;
      if (!is_known || pair.first == pair.second) others.push_back(std::move(pair));
    }
    return others;
  }

  const PairsTable& table_;
  const bool accept_sampled_;
};

}  // namespace

Exemption judged(const PairProof& proof, const std::string& reason) {
  const bool is_always = reason == kAlwaysReason;
  if (proof.verdict == Verdict::kUndecided) return Exemption::kUndecided;
  if (proof.verdict == Verdict::kContactSampled && !is_always) return Exemption::kWrong;
  if (proof.verdict != Verdict::kSometimes) return Exemption::kRight;
  return is_always && !proof.has_free_pose ? Exemption::kUndecided : Exemption::kWrong;
}

SrdfCheck checkedSrdf(const std::string& file, const std::string& text, Exemptions exempt,
                      const std::vector<std::string>& links, const std::vector<PairProof>& proofs) {
  SrdfCheck check{file, text, std::move(exempt), {}, {}, {}};
  for (const PairProof& proof : proofs) {
    const std::string* reason = check.exempt.reasonOf(links[proof.first], links[proof.second]);
    if (!reason && reasonFor(proof.verdict) && proof.verdict != Verdict::kAdjacent)
      check.forgotten.push_back(&proof);
    if (!reason) continue;
    const Exemption judgement = judged(proof, *reason);
    if (judgement == Exemption::kWrong) check.wrong.push_back(&proof);
    if (judgement == Exemption::kUndecided) check.undecided.push_back(&proof);
  }
  return check;
}

void writeCheck(const SrdfCheck& check, const std::vector<std::string>& links, bool is_merged,
                std::ostream& out) {
  const std::string file = "the SRDF \"" + printable(check.file) + "\"";
  for (const PairProof* proof : check.wrong) {
    out << file << " disables " << namesOf(*proof, links) << ", which collide at "
        << printable(argumentsOf(proof->pose)) << remedyFor(*proof)
        << (is_merged ? "; no longer disabled" : "") << '\n';
  }
  for (const PairProof* proof : check.undecided) {
    out << file << " disables " << namesOf(*proof, links)
        << ", which is not decided: " << whatIsKnown(*proof)
        << (is_merged ? "; still disabled" : "") << '\n';
  }
  for (const PairProof* proof : check.forgotten) {
    out << file << " does not disable " << namesOf(*proof, links) << ", which "
        << (proof->verdict == Verdict::kNever    ? "never collide"
            : proof->verdict == Verdict::kAlways ? "always collide"
                                                 : "always touch")
        << (is_merged ? "; now disabled" : "") << '\n';
  }
  if (check.exempt.pairs().empty()) {
    out << file << " disables no pair\n";
  } else if (check.wrong.empty()) {
    out << file << " disables no pair that was seen to collide sometimes\n";
  }
}

void writeSrdf(const PairsTable& table, bool accept_sampled, std::ostream& out) {
  const std::vector<SrdfLine> lines = SrdfWriter(table, accept_sampled).lines();
  if (table.srdf) {
    out << mergedSrdf(table.srdf->text, lines);
    return;
  }
  for (const SrdfLine& line : lines)
    out << toSrdf(line) << '\n';
}

void writeUndecided(const PairsTable& table, std::ostream& out) {
  for (const auto* proofs : {&table.rows, &table.rigid}) {
    for (const PairProof& proof : *proofs) {
      const std::string &first = table.links[proof.first], &second = table.links[proof.second];
      const bool is_kept = table.srdf && table.srdf->exempt.reasonOf(first, second);
      if (proof.verdict != Verdict::kUndecided || is_kept) continue;
      out << namesOf(proof, table.links) << " are not decided, and so not disabled\n";
    }
  }
}

}  // namespace link_bounds
