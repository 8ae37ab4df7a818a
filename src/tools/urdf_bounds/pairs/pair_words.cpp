// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/pairs/pair_words.h"

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr const char* kVerdicts[kVerdictCount] = {
    "NEVER", "ALWAYS", "TOUCHING", "CONTACT_SAMPLED", "SOMETIMES", "UNDECIDED", "ADJACENT"};
constexpr const char* kReasons[kVerdictCount] = {"Never", "Always", "Always",  nullptr,
                                                 nullptr, nullptr,  "Adjacent"};

}  // namespace

const char* toText(Verdict verdict) {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

const char* reasonFor(Verdict verdict) {
  return kReasons[static_cast<std::size_t>(verdict)];
}

std::string namesOf(const PairProof& proof, const std::vector<std::string>& links) {
  return printable(links[proof.first]) + " and " + printable(links[proof.second]);
}

std::string inAllPoses(const PairProof& proof) {
  return "all " + std::to_string(proof.poses) + " poses that were tried";
}

}  // namespace link_bounds
