// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Words for proofs about pairs of links.
#pragma once

#include <string>
#include <vector>

#include "robot/pairs/pair_proofs.h"

namespace link_bounds {

constexpr std::size_t kVerdictCount = 7;

/// As in all formats.
const char* toText(Verdict verdict);

/// MoveIt's word for a pair that needs no check; null for others.
const char* reasonFor(Verdict verdict);

/// "a and b", printable.
std::string namesOf(const PairProof& proof, const std::vector<std::string>& links);

/// "all 300 poses that were tried".
std::string inAllPoses(const PairProof& proof);

}  // namespace link_bounds
