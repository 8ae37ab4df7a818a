// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One writer per format.
#include "tools/urdf_bounds/box_table.h"

#include "tools/text/safe_text.h"
#include "tools/text/table_text.h"

namespace link_bounds {
namespace {

constexpr char kGroupPrefix[] = "group:";

/// The first vector, then the second.
Numbers numbersOf(const Aabb& box, Representation representation) {
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

Row toRow(const std::string& name, const Aabb& box, Representation representation) {
  return shortRow(name, numbersOf(box, representation));
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
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const BoxTable& table, Representation representation, std::ostream& out) {
  out << "link,a_x,a_y,a_z,b_x,b_y,b_z\n";
  for (const auto& [name, box] : table.boxes)
    writeCsvRow(name, numbersOf(box, representation), out);
  for (const auto& [name, box] : table.groups) {
    writeCsvRow(kGroupPrefix + name, numbersOf(box, representation), out);
  }
}

std::string jsonValue(const Aabb& box) {
  return "{\"min\": " + jsonNumbers(box.min()) + ", \"max\": " + jsonNumbers(box.max()) + "}";
}

void writeJson(const BoxTable& table, std::ostream& out) {
  out << "{\"frame\": " << jsonString(table.frame)
      << ",\n \"boxes\": " << jsonObject(table.boxes, jsonValue)
      << ",\n \"groups\": " << jsonObject(table.groups, jsonValue)
      << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
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
