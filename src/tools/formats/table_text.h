// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Rows, values and distances in the three formats.
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

/// The one for that format.
template <class Writer>
Writer writerFor(Format format, Writer table, Writer csv, Writer json) {
  if (format == Format::kTable) return table;
  return format == Format::kCsv ? csv : json;
}

/// Before the name of a group, where names of links and groups are mixed.
constexpr char kGroupPrefix[] = "group:";

/// Names whose volume is missing or does not cover everything, each with the reason.
using Reasons = std::vector<std::pair<std::string, std::string>>;

using Numbers = std::vector<double>;

/// The cells of a line of the table for people: a name, then numbers or their heads.
using Row = std::vector<std::string>;

/// Rounds for people: to micrometres, and without a minus sign before a zero.
std::string shortNumber(double value);
Row shortRow(const std::string& name, const Numbers& numbers);

/// A length in metres with its unit, to three digits, for people.
std::string shortLength(double length);

/// Aligns the first cells of rows, which are names, left and the others right.
class Alignment {
 public:
  explicit Alignment(std::size_t names) : names_(names) {}

  /// Before any line is made.
  void fit(const Row& row);

  /// Without a line break.
  std::string line(const Row& row) const;

 private:
  std::size_t names_;
  std::vector<std::size_t> widths_;  ///< in characters
};

/// Lines of all rows, which must be as long as the first.
void writeAligned(const std::vector<Row>& rows, std::ostream& out, std::size_t names = 1);

/// For people; writes nothing if there are none.
void writeIncomplete(const Reasons& incomplete, std::ostream& out);

void writeCsvRow(const std::string& name, const Numbers& numbers, std::ostream& out);

/// A row per name, `incomplete:NAME`, with as many empty cells as numbers stand in other rows.
void writeCsvIncomplete(const Reasons& incomplete, std::size_t numbers, std::ostream& out);

/// Adds the group of all links, unless all of them are complete.
void addIncompleteGroup(Reasons& incomplete);

Numbers numbersOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
Numbers numbersOf(const Aabb& box);  ///< min, max

/// A JSON array.
std::string jsonNumbers(const Eigen::VectorXd& numbers);

/// The two members of a JSON object that are a box.
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

/// The members of a JSON object. `more`, which begins with a comma, stands behind the distances.
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
