// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rows, values and distances as a table for people, as CSV and as JSON.
#pragma once

#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/distance/body_distance.h"
#include "text/joined.h"
#include "tools/formats/safe_text.h"

namespace link_bounds {

enum class Format { kTable, kCsv, kJson };

template <class Table>
using TableWriter = void (*)(const Table&, std::ostream&);

/// The writer of `format`.
template <class Writer>
Writer writerFor(Format format, Writer table, Writer csv, Writer json) {
  if (format == Format::kTable) return table;
  return format == Format::kCsv ? csv : json;
}

/// Prefix of the name of a group, where names of links and groups are mixed.
constexpr char kGroupPrefix[] = "group:";

/// Names of links and groups whose geometry is missing or incomplete, each with the reason.
using Reasons = std::vector<std::pair<std::string, std::string>>;

using Numbers = std::vector<double>;

/// The cells of a line of the table for people: a name, then numbers or their column heads.
using Row = std::vector<std::string>;

/// Six decimals for people, without a minus sign before a zero; nine digits from 1e9 on.
std::string shortNumber(double value);
Row shortRow(const std::string& name, const Numbers& numbers);

/// A length in metres with its unit, to three digits, for people.
std::string shortLength(double length);

/// Aligns the first `names` cells of each row left and the others right.
class Alignment {
 public:
  explicit Alignment(std::size_t names) : names_(names) {}

  /// Widens the columns for `row`. Call it for all rows before the first line().
  void fit(const Row& row);

  /// The aligned row, without a line break.
  std::string line(const Row& row) const;

 private:
  std::size_t names_;
  std::vector<std::size_t> widths_;  ///< in characters
};

/// Writes all rows as aligned lines; the first `names` cells of each row are aligned left.
void writeAligned(const std::vector<Row>& rows, std::ostream& out, std::size_t names = 1);

/// Writes a list for people; nothing if `incomplete` is empty.
void writeIncomplete(const Reasons& incomplete, std::ostream& out);

void writeCsvRow(const std::string& name, const Numbers& numbers, std::ostream& out);

/// Writes a row `incomplete:NAME` for each name, with `numbers` empty cells behind it.
void writeCsvIncomplete(const Reasons& incomplete, std::size_t numbers, std::ostream& out);

/// Adds the group of all links, unless `incomplete` is empty.
void addIncompleteGroup(Reasons& incomplete);

Numbers numbersOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
Numbers numbersOf(const Aabb& box);  ///< min, max

/// A JSON array.
std::string jsonNumbers(const Eigen::VectorXd& numbers);

/// The members "min" and "max" of a JSON object.
std::string jsonCorners(const Aabb& box);

/// A JSON object on one line. `pose` has pairs of a joint and its value.
template <class Pose>
std::string jsonPose(const Pose& pose) {
  const auto to_json = [](const auto& joint) {
    return jsonString(joint.first) + ": " + exactNumber(joint.second);
  };
  return "{" + joined(pose, ", ", to_json) + "}";
}

/// The pose as arguments of urdf_bounds: JOINT:=VALUE, with spaces between.
template <class Pose>
std::string argumentsOf(const Pose& pose) {
  return joined(pose, " ", [](const auto& joint) {
    return joint.first + ":=" + shortestNumber(joint.second);
  });
}

/// BOX, HULL or MESH.
const char* toText(DistanceLevel level);

/// Members of a JSON object about two bodies. `more` begins with a comma and follows the distances.
std::string jsonMembers(const std::string& first, const std::string& second,
                        const BodyDistance& distance, const std::string& more = "");

/// A JSON array with one element per line.
template <class Elements, class ToJson>
void writeJsonList(const Elements& elements, const ToJson& to_json, std::ostream& out) {
  out << '[';
  const char* separator = "\n  ";
  for (const auto& element : elements)
    out << std::exchange(separator, ",\n  ") << to_json(element);
  out << ']';
}

template <class Elements, class ToJson>
std::string jsonList(const Elements& elements, const ToJson& to_json) {
  std::ostringstream out;
  writeJsonList(elements, to_json, out);
  return out.str();
}

/// A JSON object with one member per line.
template <class Value, class ToJson>
std::string jsonObject(const std::vector<std::pair<std::string, Value>>& members,
                       const ToJson& to_json) {
  std::string result;
  for (const auto& [name, value] : members) {
    result += (result.empty() ? "\n  " : ",\n  ") + jsonString(name) + ": " + to_json(value);
  }
  return "{" + result + "}";
}

}  // namespace link_bounds
