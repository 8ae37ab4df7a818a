// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Columns are as wide as their widest cell.
#include "tools/formats/table_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace link_bounds {

std::string shortNumber(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  if (std::abs(value) < 1e9) {
    out << std::fixed << std::setprecision(6) << (std::abs(value) <= 5e-7 ? 0.0 : value);
  } else {
    out << std::setprecision(9) << value;
  }
  return out.str();
}

Row shortRow(const std::string& name, const Numbers& numbers) {
  Row row{name};
  for (const double number : numbers)
    row.push_back(shortNumber(number));
  return row;
}

std::string shortLength(double length) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << length << " m";
  return text.str();
}

/// Counts characters; std::setw would count bytes.
void Alignment::fit(const Row& row) {
  widths_.resize(std::max(widths_.size(), row.size()));
  for (std::size_t k = 0; k < row.size(); ++k)
    widths_[k] = std::max(widths_[k], characterCount(row[k]));
}

std::string Alignment::line(const Row& row) const {
  std::string line;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::string spaces(widths_[k] - characterCount(row[k]), ' ');
    line += (k > 0 ? "  " : "") + (k < names_ ? row[k] + spaces : spaces + row[k]);
  }
  return line;
}

void writeAligned(const std::vector<Row>& rows, std::ostream& out, std::size_t names) {
  Alignment alignment(names);
  for (const Row& row : rows)
    alignment.fit(row);
  for (const Row& row : rows)
    out << alignment.line(row) << '\n';
}

void writeIncomplete(const Reasons& incomplete, std::ostream& out) {
  if (incomplete.empty()) return;
  out << "\nincomplete:\n";
  for (const auto& [name, reason] : incomplete) {
    out << "  " << printable(name) << ": " << printable(reason) << '\n';
  }
}

void writeCsvRow(const std::string& name, const Numbers& numbers, std::ostream& out) {
  out << csvField(name);
  for (const double number : numbers)
    out << ',' << exactNumber(number);
  out << '\n';
}

void writeCsvIncomplete(const Reasons& incomplete, std::size_t numbers, std::ostream& out) {
  for (const auto& [name, reason] : incomplete)
    out << csvField("incomplete:" + name) << std::string(numbers, ',') << '\n';
}

void addIncompleteGroup(Reasons& incomplete) {
  if (incomplete.empty()) return;
  const bool is_one = incomplete.size() == 1;
  std::string reason = "link \"" + incomplete.front().first + "\"";
  if (!is_one) reason += " and " + std::to_string(incomplete.size() - 1) + " more";
  incomplete.emplace_back(std::string(kGroupPrefix) + "robot",
                          reason + (is_one ? " is incomplete" : " are incomplete"));
}

Numbers numbersOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

Numbers numbersOf(const Aabb& box) {
  return numbersOf(box.min(), box.max());
}

std::string jsonCorners(const Aabb& box) {
  return "\"min\": " + jsonNumbers(box.min()) + ", \"max\": " + jsonNumbers(box.max());
}

std::string jsonNumbers(const Eigen::VectorXd& numbers) {
  std::string result;
  for (Eigen::Index k = 0; k < numbers.size(); ++k)
    result += (k == 0 ? "" : ", ") + exactNumber(numbers[k]);
  return "[" + result + "]";
}

const char* toText(DistanceLevel level) {
  constexpr std::array<const char*, 3> kLevels{"BOX", "HULL", "MESH"};
  return kLevels.at(static_cast<std::size_t>(level));
}

std::string jsonMembers(const std::string& first, const std::string& second,
                        const BodyDistance& distance, const std::string& more) {
  return "\"first\": " + jsonString(first) + ", \"second\": " + jsonString(second) +
         ", \"distance\": " + exactNumber(distance.lower) +
         ", \"distance_max\": " + exactNumber(distance.upper) + more +
         ", \"on_first\": " + jsonNumbers(distance.on_first) +
         ", \"on_second\": " + jsonNumbers(distance.on_second) +
         ", \"normal\": " + jsonNumbers(distance.normal) + ", \"level\": \"" +
         toText(distance.level) + "\"";
}

}  // namespace link_bounds
