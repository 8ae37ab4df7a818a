// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/urdf_bounds/path/path_table.h"

#include <array>
#include <cmath>

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

constexpr std::size_t kRowNames = 1;  ///< columns that are aligned left

/// In which no pose was measured.
bool isUnknown(const SegmentProof& proof) {
  return !std::isfinite(proof.nearest);
}

Row cellsOf(const PathSegment& segment) {
  const SegmentProof& proof = segment.proof;
  Row row = shortRow(toText(proof.verdict), {proof.clearance, proof.nearest, proof.share});
  if (isUnknown(proof)) row[2] = row[3] = "-";
  row.insert(row.begin() + 1, {std::to_string(segment.from), std::to_string(segment.to)});
  return row;
}

std::string namesOf(const PathTable& table, const SegmentProof& proof) {
  if (isUnknown(proof)) return "";
  return printable(table.bodies[proof.first]) + " and " + printable(table.bodies[proof.second]);
}

void writeTable(const PathTable& table, std::ostream& out) {
  out << "unit: m    bodies collide where they "
      << (table.clearance > 0 ? "are within " + shortestNumber(table.clearance) : "touch")
      << "    at: share of the segment\n\n";
  const Row head{"verdict", "from", "to", "clearance", "nearest", "at"};
  Alignment alignment(kRowNames);
  alignment.fit(head);
  for (const PathSegment& segment : table.segments)
    alignment.fit(cellsOf(segment));
  out << alignment.line(head) << "  nearest bodies\n";
  std::array<std::size_t, 3> counts{};
  for (const PathSegment& segment : table.segments) {
    out << alignment.line(cellsOf(segment)) << "  " << namesOf(table, segment.proof) << '\n';
    ++counts[static_cast<std::size_t>(segment.proof.verdict)];
  }
  out << '\n' << table.segments.size() << (table.segments.size() == 1 ? " segment" : " segments");
  for (std::size_t i = 0; i < counts.size(); ++i)
    out << (i == 0 ? ": " : ", ") << counts[i] << ' ' << toText(static_cast<PathVerdict>(i));
  out << '\n';
  for (const PathSegment& segment : table.segments) {
    if (segment.proof.verdict != PathVerdict::kCollides) continue;
    out << "from row " << segment.from << " to row " << segment.to << ", "
        << namesOf(table, segment.proof) << " collide at " << printable(argumentsOf(segment.pose))
        << '\n';
  }
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const PathTable& table, std::ostream& out) {
  out << "from,to,verdict,clearance,nearest,first,second,at,pose\n";
  for (const PathSegment& segment : table.segments) {
    const SegmentProof& proof = segment.proof;
    out << segment.from << ',' << segment.to << ',' << toText(proof.verdict) << ','
        << exactNumber(proof.clearance) << ',';
    if (isUnknown(proof)) {
      out << ",,,,\n";
      continue;
    }
    out << exactNumber(proof.nearest) << ',' << csvField(table.bodies[proof.first]) << ','
        << csvField(table.bodies[proof.second]) << ',' << exactNumber(proof.share) << ','
        << csvField(argumentsOf(segment.pose)) << '\n';
  }
}

std::string toJson(const PathTable& table, const PathSegment& segment) {
  const SegmentProof& proof = segment.proof;
  std::string text = "{\"from\": " + std::to_string(segment.from) +
                     ", \"to\": " + std::to_string(segment.to) + ", \"verdict\": \"" +
                     toText(proof.verdict) + "\", \"clearance\": " + exactNumber(proof.clearance);
  if (isUnknown(proof)) return text + ", \"nearest\": null, \"at\": null, \"pose\": {}}";
  return text + ", \"nearest\": " + exactNumber(proof.nearest) +
         ", \"first\": " + jsonString(table.bodies[proof.first]) +
         ", \"second\": " + jsonString(table.bodies[proof.second]) +
         ", \"at\": " + exactNumber(proof.share) + ", \"pose\": " + jsonPose(segment.pose) + "}";
}

void writeJson(const PathTable& table, std::ostream& out) {
  const auto to_json = [&](const PathSegment& segment) { return toJson(table, segment); };
  out << "{\"segments\": ";
  writeJsonList(table.segments, to_json, out);
  out << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

}  // namespace

void write(const PathTable& table, Format format, std::ostream& out) {
  writerFor<PathTable>(format, writeTable, writeCsv, writeJson)(table, out);
}

}  // namespace link_bounds
