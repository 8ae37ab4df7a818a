// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/pairs/srdf_check.h"

#include <cmath>

#include "tools/formats/safe_text.h"
#include "tools/formats/table_text.h"
#include "tools/urdf_bounds/pairs/pair_words.h"

namespace link_bounds {
namespace {

std::string metres(double value) {
  return shortNumber(value) + " m";
}

std::string whatIsKnown(const PairProof& proof) {
  if (!std::isfinite(proof.nearest)) return "no pose was tried";
  return "they are never nearer than " + metres(proof.clearance) + ", and " +
         metres(proof.nearest) + " apart at " + printable(argumentsOf(proof.pose));
}

/// Where all poses collide, another reason would be right.
std::string remedyFor(const PairProof& proof) {
  if (proof.verdict != Verdict::kContactSampled) return "";
  return ", as in " + inAllPoses(proof) + "; reason=\"Always\" says so";
}

}  // namespace

Exemption judged(const PairProof& proof, const std::string& reason) {
  const bool is_always = reason == kAlways;
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
  if (check.wrong.empty()) out << file << " disables no pair that was seen to collide sometimes\n";
}

}  // namespace link_bounds
