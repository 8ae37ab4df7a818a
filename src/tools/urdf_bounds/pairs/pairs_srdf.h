// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a SRDF exempts, beside what is proven, and verdicts about pairs of links as a SRDF.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "robot/pairs/pair_proofs.h"
#include "robot/pairs/srdf.h"

namespace link_bounds {

struct PairsTable;

enum class Exemption { kRight, kWrong, kUndecided };

/// What is to say of an exemption with that reason. Of a pair that collided in all poses, "Always"
/// is the right one.
Exemption judged(const PairProof& proof, const std::string& reason);

struct SrdfCheck {
  std::string file;
  std::string text;
  Exemptions exempt;
  std::vector<const PairProof*> wrong;      ///< exempt, but they can collide
  std::vector<const PairProof*> undecided;  ///< exempt
  std::vector<const PairProof*> forgotten;  ///< not exempt, but they need no check
};

/// `links` are the names of the links of the proofs, which live as long as the result.
SrdfCheck checkedSrdf(const std::string& file, const std::string& text, Exemptions exempt,
                      const std::vector<std::string>& links, const std::vector<PairProof>& proofs);

/// For people; one line per pair. `is_merged`: also what becomes of it in the new SRDF.
void writeCheck(const SrdfCheck& check, const std::vector<std::string>& links, bool is_merged,
                std::ostream& out);

/// What is proven, as elements, or as the SRDF of the table with these and with those of its own
/// that are not refuted. `accept_sampled`: also pairs that collided in all poses that were tried.
void writeSrdf(const PairsTable& table, bool accept_sampled, std::ostream& out);

/// For people: the pairs without an element because they are not decided.
void writeUndecided(const PairsTable& table, std::ostream& out);

}  // namespace link_bounds
