// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One writer per format.
#include "box_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "safe_text.h"

namespace link_bounds {
namespace {

using Row = std::array<std::string, 7>;

constexpr char kGroupPrefix[] = "group:";

/// a, then b.
std::array<double, 6> numbersOf(const Aabb& box, Representation representation) {
  Eigen::Vector3d a = box.min();
  Eigen::Vector3d b = box.max();
  if (representation == Representation::kMinWidth) {
    b = toMinWidth(box).width;
  } else if (representation == Representation::kCenterRadius) {
    const CenterRadius form = toCenterRadius(box);
    a = form.center;
    b = form.radius;
  }
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

/// For people: micrometres, and no minus sign before a zero.
std::string shortNumber(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  if (std::abs(value) < 1e9) {
    out << std::fixed << std::setprecision(6) << (std::abs(value) < 5e-7 ? 0.0 : value);
  } else {
    out << std::setprecision(9) << value;
  }
  return out.str();
}

Row toRow(const std::string& name, const Aabb& box, Representation representation) {
  Row row{name};
  const std::array<double, 6> numbers = numbersOf(box, representation);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    row[k + 1] = shortNumber(numbers[k]);
  return row;
}

Row headOf(Representation representation) {
  switch (representation) {
    case Representation::kMinMax:
      return {"link", "min x", "min y", "min z", "max x", "max y", "max z"};
    case Representation::kMinWidth:
      return {"link", "min x", "min y", "min z", "width x", "width y", "width z"};
    case Representation::kCenterRadius:
      return {"link", "center x", "center y", "center z", "radius x", "radius y", "radius z"};
  }
  return {};
}

const char* nameOf(Representation representation) {
  switch (representation) {
    case Representation::kMinMax:
      return "min-max";
    case Representation::kMinWidth:
      return "min-width";
    case Representation::kCenterRadius:
      return "center-radius";
  }
  return "";
}

/// Names to the left, numbers to the right; only characters count, as setw would count bytes.
void writeAligned(const std::vector<Row>& rows, std::ostream& out) {
  std::array<std::size_t, 7> widths{};
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      widths[k] = std::max(widths[k], characterCount(row[k]));
    }
  }
  for (const Row& row : rows) {
    out << row[0] << std::string(widths[0] - characterCount(row[0]), ' ');
    for (std::size_t k = 1; k < row.size(); ++k) {
      out << "  " << std::string(widths[k] - row[k].size(), ' ') << row[k];
    }
    out << '\n';
  }
}

void writeTable(const BoxTable& table, Representation representation, std::ostream& out) {
  out << "frame: " << printable(table.frame)
      << "    unit: m    representation: " << nameOf(representation) << "\n\n";
  std::vector<Row> rows{headOf(representation)};
  for (const auto& [name, box] : table.boxes) {
    rows.push_back(toRow(printable(name), box, representation));
  }
  for (const auto& [name, box] : table.groups) {
    rows.push_back(toRow(kGroupPrefix + name, box, representation));
  }
  writeAligned(rows, out);
  if (table.boxes.empty()) out << "(no link has a box)\n";
  if (table.incomplete.empty()) return;
  out << "\nincomplete:\n";
  for (const auto& [name, reason] : table.incomplete) {
    out << "  " << printable(name) << ": " << printable(reason) << '\n';
  }
}

void writeCsvRow(const std::string& name, const Aabb& box, Representation representation,
                 std::ostream& out) {
  out << csvField(name);
  for (const double number : numbersOf(box, representation))
    out << ',' << exactNumber(number);
  out << '\n';
}

void writeCsv(const BoxTable& table, Representation representation, std::ostream& out) {
  out << "link,a_x,a_y,a_z,b_x,b_y,b_z\n";
  for (const auto& [name, box] : table.boxes)
    writeCsvRow(name, box, representation, out);
  for (const auto& [name, box] : table.groups) {
    writeCsvRow(kGroupPrefix + name, box, representation, out);
  }
}

std::string jsonValue(const Eigen::Vector3d& v) {
  return "[" + exactNumber(v.x()) + ", " + exactNumber(v.y()) + ", " + exactNumber(v.z()) + "]";
}

std::string jsonValue(const Aabb& box) {
  return "{\"min\": " + jsonValue(box.min()) + ", \"max\": " + jsonValue(box.max()) + "}";
}

std::string jsonValue(const std::string& text) {
  return jsonString(text);
}

/// One member per line.
template <class Value>
std::string jsonObject(const std::vector<std::pair<std::string, Value>>& members) {
  std::string result;
  for (const auto& [name, value] : members) {
    result += (result.empty() ? "\n  " : ",\n  ") + jsonString(name) + ": " + jsonValue(value);
  }
  return "{" + result + "}";
}

void writeJson(const BoxTable& table, std::ostream& out) {
  out << "{\"frame\": " << jsonString(table.frame) << ",\n \"boxes\": " << jsonObject(table.boxes)
      << ",\n \"groups\": " << jsonObject(table.groups)
      << ",\n \"incomplete\": " << jsonObject(table.incomplete) << "}\n";
}

}  // namespace

void writeBoxes(const BoxTable& table, Format format, Representation representation,
                std::ostream& out) {
  switch (format) {
    case Format::kTable:
      return writeTable(table, representation, out);
    case Format::kCsv:
      return writeCsv(table, representation, out);
    case Format::kJson:
      return writeJson(table, out);
  }
}

}  // namespace link_bounds
