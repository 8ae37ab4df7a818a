// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Verdicts about pairs of links as text: a table to read, CSV, JSON or SRDF.
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "robot/pairs/pair_proofs.h"
#include "robot/pairs/srdf.h"
#include "tools/text/table_text.h"

namespace link_bounds {

struct PairRow {
  std::string first;
  std::string second;
  PairProof proof;
};

/// What a SRDF says beside what is proven. Pairs by their rows.
struct SrdfCheck {
  std::string file;
  std::vector<const PairRow*> wrong;      ///< disabled, but they can collide
  std::vector<const PairRow*> undecided;  ///< disabled
  std::vector<const PairRow*> forgotten;  ///< not disabled, but they never or always collide
};

struct PairsTable {
  double clearance = 0;                ///< links that are as near collide [m]
  std::vector<PairRow> rows;           ///< in the order of the links
  std::vector<DisabledPair> adjacent;  ///< no rows, because joints or nothing are between them
  std::optional<SrdfCheck> srdf;
  Reasons incomplete;
};

/// Why nothing is known about pairs, and about how many.
std::map<std::string, std::size_t> reasonsOf(const PairsTable& table);

/// For people.
void writeTable(const PairsTable& table, std::ostream& out);

void writeCsv(const PairsTable& table, std::ostream& out);

void writeJson(const PairsTable& table, std::ostream& out);

/// The elements of what is proven, and of adjacent pairs.
void writeSrdf(const PairsTable& table, std::ostream& out);

/// For people; one line per pair.
void writeCheck(const SrdfCheck& check, std::ostream& out);

}  // namespace link_bounds
