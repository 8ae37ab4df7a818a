// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Verdicts about pairs of links as text: a table to read, CSV or JSON.
#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tools/formats/table_text.h"
#include "tools/urdf_bounds/pairs/pairs_srdf.h"

namespace link_bounds {

struct PairsTable {
  double clearance = 0;            ///< links nearer than this collide [m]; 0: if they touch
  std::vector<std::string> links;  ///< names
  std::vector<PairProof> rows;     ///< in the order of the links
  std::vector<PairProof> rigid;    ///< pairs of rigidly joined links; only for an SRDF
  std::optional<SrdfCheck> srdf;   ///< the check of `rows` against the SRDF
  Reasons incomplete;
};

/// "a and b", printable.
std::string namesOf(const PairProof& proof, const std::vector<std::string>& links);

/// "all 300 poses that were tried".
std::string inAllPoses(const PairProof& proof);

/// The reasons why pairs are undecided, each with the number of pairs.
std::map<std::string, std::size_t> reasonsOf(const PairsTable& table);

/// For people.
void writeTable(const PairsTable& table, std::ostream& out);

void writeCsv(const PairsTable& table, std::ostream& out);

void writeJson(const PairsTable& table, std::ostream& out);

}  // namespace link_bounds
