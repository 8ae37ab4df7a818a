// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/pair_words.h"

#include <locale>
#include <sstream>

#include "tools/text/safe_text.h"

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

std::string argumentsOf(const PairProof& proof) {
  std::string result;
  for (const auto& [joint, value] : proof.pose)
    result += (result.empty() ? "" : " ") + joint + ":=" + shortestNumber(value);
  return result;
}

std::string inAllPoses(const PairProof& proof) {
  return "all " + std::to_string(proof.poses) + " poses that were tried";
}

std::string shortestNumber(double value) {
  for (int digits = 1; digits < 17; ++digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << value + 0.0;
    std::istringstream in(out.str());
    in.imbue(std::locale::classic());
    double read = 0;
    if (in >> read && read == value) return out.str();
  }
  return exactNumber(value);
}

}  // namespace link_bounds
