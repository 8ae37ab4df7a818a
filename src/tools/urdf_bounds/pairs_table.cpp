// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A pose is written as the arguments that give it to urdf_bounds.
#include "tools/urdf_bounds/pairs_table.h"

#include <algorithm>
#include <locale>
#include <sstream>

#include "tools/text/safe_text.h"

namespace link_bounds {
namespace {

constexpr const char* kVerdicts[] = {"NEVER", "ALWAYS", "SOMETIMES", "UNDECIDED"};
constexpr std::size_t kNames = 3;  ///< columns that are aligned left

const char* toText(Verdict verdict) {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

/// With as few digits as give the same double.
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

std::string argumentsOf(const PairProof& proof) {
  std::string result;
  for (const auto& [joint, value] : proof.pose)
    result += (result.empty() ? "" : " ") + joint + ":=" + shortestNumber(value);
  return result;
}

std::string toJson(const PairRow& row) {
  const std::vector<std::pair<std::string, double>> pose(row.proof.pose.begin(),
                                                         row.proof.pose.end());
  std::string joints;
  for (const auto& [joint, value] : pose)
    joints += (joints.empty() ? "" : ", ") + jsonString(joint) + ": " + exactNumber(value);
  return "{\"first\": " + jsonString(row.first) + ", \"second\": " + jsonString(row.second) +
         ", \"verdict\": \"" + toText(row.proof.verdict) +
         "\", \"clearance\": " + exactNumber(row.proof.clearance) +
         ", \"nearest\": " + exactNumber(row.proof.nearest) + ", \"pose\": {" + joints + "}" +
         (row.proof.reason.empty() ? "" : ", \"reason\": " + jsonString(row.proof.reason)) + "}";
}

/// A JSON array of pairs of names.
std::string toJson(const std::vector<const PairRow*>& rows) {
  std::string result;
  for (const PairRow* row : rows) {
    result += (result.empty() ? "[" : ", [") + jsonString(row->first) + ", " +
              jsonString(row->second) + "]";
  }
  return "[" + result + "]";
}

std::string namesOf(const PairRow& row) {
  return printable(row.first) + " and " + printable(row.second);
}

std::string metres(double value) {
  return shortRow("", {value})[1] + " m";
}

/// How many pairs have each verdict.
void writeSummary(const PairsTable& table, std::ostream& out) {
  out << '\n' << table.rows.size() << (table.rows.size() == 1 ? " pair" : " pairs");
  const char* separator = ": ";
  for (const Verdict verdict :
       {Verdict::kNever, Verdict::kAlways, Verdict::kSometimes, Verdict::kUndecided}) {
    const auto count =
        std::count_if(table.rows.begin(), table.rows.end(),
                      [verdict](const PairRow& row) { return row.proof.verdict == verdict; });
    out << separator << count << ' ' << toText(verdict);
    separator = ", ";
  }
  out << '\n';
  for (const PairRow& row : table.rows) {
    if (row.proof.verdict == Verdict::kSometimes && !row.proof.has_free_pose)
      out << namesOf(row) << " collide in every pose that was tried\n";
  }
  for (const auto& [reason, count] : reasonsOf(table))
    out << count << " UNDECIDED: " << printable(reason) << '\n';
}

}  // namespace

std::map<std::string, std::size_t> reasonsOf(const PairsTable& table) {
  std::map<std::string, std::size_t> reasons;
  for (const PairRow& row : table.rows) {
    if (!row.proof.reason.empty()) ++reasons[row.proof.reason];
  }
  return reasons;
}

void writeTable(const PairsTable& table, std::ostream& out) {
  out << "unit: m    links collide where they "
      << (table.clearance > 0 ? "are nearer than " + shortestNumber(table.clearance) : "touch")
      << "\n\n";
  std::vector<Row> rows{{"first", "second", "verdict", "clearance", "nearest"}};
  std::vector<std::string> poses{"pose"};
  for (const PairRow& row : table.rows) {
    Row cells = shortRow(printable(row.first), {row.proof.clearance, row.proof.nearest});
    cells.insert(cells.begin() + 1, {printable(row.second), toText(row.proof.verdict)});
    rows.push_back(cells);
    poses.push_back(printable(argumentsOf(row.proof)));
  }
  std::ostringstream aligned;
  writeAligned(rows, aligned, kNames);
  std::istringstream lines(aligned.str());
  std::string line;
  for (const std::string& pose : poses) {
    std::getline(lines, line);
    out << line << (pose.empty() ? "" : "  ") << pose << '\n';
  }
  writeSummary(table, out);
  if (table.srdf) writeCheck(*table.srdf, out << '\n');
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const PairsTable& table, std::ostream& out) {
  out << "first,second,verdict,clearance,nearest,pose\n";
  for (const PairRow& row : table.rows) {
    out << csvField(row.first) << ',' << csvField(row.second) << ',' << toText(row.proof.verdict)
        << ',' << exactNumber(row.proof.clearance) << ',' << exactNumber(row.proof.nearest) << ','
        << csvField(argumentsOf(row.proof)) << '\n';
  }
}

void writeJson(const PairsTable& table, std::ostream& out) {
  out << "{\"pairs\": [";
  const char* separator = "\n  ";
  for (const PairRow& row : table.rows) {
    out << separator << toJson(row);
    separator = ",\n  ";
  }
  out << "]";
  if (table.srdf) {
    out << ",\n \"srdf\": {\"wrong\": " << toJson(table.srdf->wrong)
        << ", \"undecided\": " << toJson(table.srdf->undecided)
        << ", \"forgotten\": " << toJson(table.srdf->forgotten) << "}";
  }
  out << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

void writeSrdf(const PairsTable& table, std::ostream& out) {
  for (const DisabledPair& pair : table.adjacent)
    out << toSrdf(pair) << '\n';
  for (const PairRow& row : table.rows) {
    const bool is_never = row.proof.verdict == Verdict::kNever;
    if (!is_never && row.proof.verdict != Verdict::kAlways) continue;
    out << toSrdf({row.first, row.second, is_never ? "Never" : "Always"}) << '\n';
  }
}

void writeCheck(const SrdfCheck& check, std::ostream& out) {
  const std::string file = "the SRDF \"" + printable(check.file) + "\"";
  for (const PairRow* row : check.wrong) {
    out << file << " disables " << namesOf(*row) << ", which collide at "
        << printable(argumentsOf(row->proof)) << '\n';
  }
  for (const PairRow* row : check.undecided) {
    out << file << " disables " << namesOf(*row)
        << ", which is not decided: they are never nearer than " << metres(row->proof.clearance)
        << ", and " << metres(row->proof.nearest) << " apart at "
        << printable(argumentsOf(row->proof)) << '\n';
  }
  for (const PairRow* row : check.forgotten) {
    out << file << " does not disable " << namesOf(*row) << ", which "
        << (row->proof.verdict == Verdict::kNever ? "never" : "always") << " collide\n";
  }
  if (check.wrong.empty()) out << file << " disables no pair that was seen to collide sometimes\n";
}

}  // namespace link_bounds
