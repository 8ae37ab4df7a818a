// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rows are made one by one to save memory: a robot of a thousand links has half a million pairs.
#include "tools/urdf_bounds/pairs/pairs_table.h"

#include <array>
#include <cmath>

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr std::size_t kPairNames = 3;  ///< columns that are aligned left

/// Whether no pose of this pair was tried.
bool isUnknown(const PairProof& proof) {
  return !std::isfinite(proof.nearest);
}

std::string toJson(const PairProof& proof, const std::vector<std::string>& links) {
  const bool is_sampled = proof.verdict == Verdict::kContactSampled;
  return "{\"first\": " + jsonString(links[proof.first]) +
         ", \"second\": " + jsonString(links[proof.second]) + ", \"verdict\": \"" +
         toText(proof.verdict) + "\", \"clearance\": " + exactNumber(proof.clearance) +
         ", \"nearest\": " + (isUnknown(proof) ? "null" : exactNumber(proof.nearest)) +
         ", \"pose\": " + jsonPose(proof.pose) +
         (is_sampled ? ", \"poses\": " + std::to_string(proof.poses) : "") +
         (proof.reason.empty() ? "" : ", \"reason\": " + jsonString(proof.reason)) + "}";
}

/// A JSON array of pairs of names.
std::string toJson(const std::vector<const PairProof*>& proofs,
                   const std::vector<std::string>& links) {
  const auto names = [&](const PairProof* proof) {
    return "[" + jsonString(links[proof->first]) + ", " + jsonString(links[proof->second]) + "]";
  };
  return "[" + joined(proofs, ", ", names) + "]";
}

Row cellsOf(const PairProof& proof, const std::vector<std::string>& links) {
  Row cells = shortRow(printable(links[proof.first]), {proof.clearance, proof.nearest});
  if (isUnknown(proof)) cells.back() = "-";
  cells.insert(cells.begin() + 1, {printable(links[proof.second]), toText(proof.verdict)});
  return cells;
}

/// How many pairs have each verdict.
void writeSummary(const PairsTable& table, std::ostream& out) {
  std::array<std::size_t, kVerdictCount> counts{};
  for (const PairProof& proof : table.rows)
    ++counts[static_cast<std::size_t>(proof.verdict)];
  out << '\n' << table.rows.size() << (table.rows.size() == 1 ? " pair" : " pairs");
  for (std::size_t i = 0; i < kVerdictCount; ++i)
    out << (i == 0 ? ": " : ", ") << counts[i] << ' ' << toText(static_cast<Verdict>(i));
  out << '\n';
  for (const PairProof& proof : table.rows) {
    const bool is_contact =
        proof.verdict == Verdict::kContactSampled || proof.verdict == Verdict::kSometimes;
    if (!is_contact || proof.has_free_pose) continue;
    out << namesOf(proof, table.links) << " collided in " << inAllPoses(proof)
        << "; nothing is proven of others\n";
  }
  for (const auto& [reason, count] : reasonsOf(table))
    out << count << " UNDECIDED: " << printable(reason) << '\n';
}

}  // namespace

std::string namesOf(const PairProof& proof, const std::vector<std::string>& links) {
  return printable(links[proof.first]) + " and " + printable(links[proof.second]);
}

std::string inAllPoses(const PairProof& proof) {
  return "all " + std::to_string(proof.poses) + " poses that were tried";
}

std::map<std::string, std::size_t> reasonsOf(const PairsTable& table) {
  std::map<std::string, std::size_t> reasons;
  for (const PairProof& proof : table.rows) {
    if (!proof.reason.empty()) ++reasons[proof.reason];
  }
  return reasons;
}

void writeTable(const PairsTable& table, std::ostream& out) {
  out << "unit: m    links collide where they "
      << (table.clearance > 0 ? "are nearer than " + shortestNumber(table.clearance) : "touch")
      << "\n\n";
  const Row head{"first", "second", "verdict", "clearance", "nearest"};
  Alignment alignment(kPairNames);
  alignment.fit(head);
  for (const PairProof& proof : table.rows)
    alignment.fit(cellsOf(proof, table.links));
  out << alignment.line(head) << "  pose\n";
  for (const PairProof& proof : table.rows) {
    out << alignment.line(cellsOf(proof, table.links));
    if (!proof.pose.empty()) out << "  " << printable(argumentsOf(proof.pose));
    out << '\n';
  }
  writeSummary(table, out);
  if (table.srdf) writeCheck(*table.srdf, table.links, false, out << '\n');
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const PairsTable& table, std::ostream& out) {
  out << "first,second,verdict,clearance,nearest,pose,poses\n";
  for (const PairProof& proof : table.rows) {
    out << csvField(table.links[proof.first]) << ',' << csvField(table.links[proof.second]) << ','
        << toText(proof.verdict) << ',' << exactNumber(proof.clearance) << ','
        << (isUnknown(proof) ? "" : exactNumber(proof.nearest)) << ','
        << csvField(argumentsOf(proof.pose)) << ',';
    if (proof.verdict == Verdict::kContactSampled) out << proof.poses;
    out << '\n';
  }
}

void writeJson(const PairsTable& table, std::ostream& out) {
  out << "{\"pairs\": ";
  writeJsonList(
      table.rows, [&](const PairProof& proof) { return toJson(proof, table.links); }, out);
  if (table.srdf) {
    out << ",\n \"srdf\": {\"wrong\": " << toJson(table.srdf->wrong, table.links)
        << ", \"undecided\": " << toJson(table.srdf->undecided, table.links)
        << ", \"forgotten\": " << toJson(table.srdf->forgotten, table.links) << "}";
  }
  out << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

}  // namespace link_bounds
