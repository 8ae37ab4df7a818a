// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares the exemptions of an SRDF with the proofs, and writes verdicts as an SRDF.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "robot/pairs/pair_proofs.h"
#include "robot/pairs/srdf.h"

namespace link_bounds {

struct PairsTable;

enum class Exemption { kRight, kWrong, kUndecided };

/// Whether the SRDF may exempt this pair for `reason`. For a pair that collided in all poses that
/// were tried, only "Always" is right.
Exemption judged(const PairProof& proof, const std::string& reason);

struct SrdfCheck {
  std::string file;
  std::string text;
  Exemptions exempt;
  std::vector<const PairProof*> wrong;      ///< exempt, but they can collide
  std::vector<const PairProof*> undecided;  ///< exempt, but nothing proves the reason
  std::vector<const PairProof*> forgotten;  ///< not exempt, but they need no check
};

/// `links` are the names by link index. The result points into `proofs`, which must outlive it.
SrdfCheck checkedSrdf(const std::string& file, const std::string& text, Exemptions exempt,
                      const std::vector<std::string>& links, const std::vector<PairProof>& proofs);

/// For people; one line per pair. `is_merged`: also says whether the new SRDF disables the pair.
void writeCheck(const SrdfCheck& check, const std::vector<std::string>& links, bool is_merged,
                std::ostream& out);

/// Writes the proven pairs as disable_collisions elements. If the table has an SRDF, writes all of
/// it with these elements and its own ones, except those that are refuted. `accept_sampled`: also
/// pairs that collided in all poses that were tried.
void writeSrdf(const PairsTable& table, bool accept_sampled, std::ostream& out);

/// Lists for people the undecided pairs, which have no element.
void writeUndecided(const PairsTable& table, std::ostream& out);

}  // namespace link_bounds
