// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The same numbers in the same order in each format.
#include "tools/urdf_bounds/reach/reach_table.h"

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

/// Thin lines around a link, thick ones around the robot: both are seen where they coincide.
constexpr char kThin[] = "{x: 0.005}, color: {r: 0.1, g: 0.7, b: 1.0, a: 0.6}";
constexpr char kThick[] = "{x: 0.015}, color: {r: 1.0, g: 0.5, b: 0.1, a: 1.0}";

Numbers numbersOf(const Reach& reach) {
  Numbers numbers;
  for (const ReachFace& face : reach.faces)
    numbers.push_back(face.at);
  return numbers;
}

Row rowOf(const std::string& name, const Reach& reach) {
  Numbers numbers = numbersOf(reach);
  numbers.push_back(reach.maxGap());
  return shortRow(name, numbers);
}

void writeTable(const ReachTable& table, std::ostream& out) {
  out << "frame: " << printable(table.frame)
      << "    unit: m    the links never leave these boxes; gap: a pose is as near to each "
         "face\n\n";
  std::vector<Row> rows{{"link", "min x", "min y", "min z", "max x", "max y", "max z", "gap"}};
  for (const auto& [name, reach] : table.links)
    rows.push_back(rowOf(printable(name), reach));
  for (const auto& [name, reach] : table.groups)
    rows.push_back(rowOf(kGroupPrefix + name, reach));
  writeAligned(rows, out);
  if (table.links.empty()) out << "(no link has a box)\n";
  writeIncomplete(table.incomplete, out);
}

void writeReachRow(const std::string& name, const Reach& reach, std::ostream& out) {
  Numbers numbers = numbersOf(reach);
  for (const ReachFace& face : reach.faces)
    numbers.push_back(face.gap());
  writeCsvRow(name, numbers, out);
}

void writeCsv(const ReachTable& table, std::ostream& out) {
  out << "link,min_x,min_y,min_z,max_x,max_y,max_z,"
         "gap_min_x,gap_min_y,gap_min_z,gap_max_x,gap_max_y,gap_max_z\n";
  for (const auto& [name, reach] : table.links)
    writeReachRow(name, reach, out);
  for (const auto& [name, reach] : table.groups)
    writeReachRow(kGroupPrefix + name, reach, out);
  writeCsvIncomplete(table.incomplete, 2 * kFaces, out);
}

std::string toJson(const Reach& reach) {
  const Aabb box = reach.box();
  const auto gap = [](const ReachFace& face) { return exactNumber(face.gap()); };
  const auto pose = [](const ReachFace& face) { return jsonPose(face.pose); };
  return "{\"min\": " + jsonNumbers(box.min()) + ", \"max\": " + jsonNumbers(box.max()) +
         ",\n   \"gap\": [" + joined(reach.faces, ", ", gap) + "],\n   \"attained\": [" +
         joined(reach.faces, ",\n    ", pose) + "]}";
}

void writeJson(const ReachTable& table, std::ostream& out) {
  const auto to_json = [](const Reach& reach) { return toJson(reach); };
  out << "{\"frame\": " << jsonString(table.frame)
      << ",\n \"accuracy\": " << exactNumber(table.accuracy)
      << ",\n \"reach\": " << jsonObject(table.links, to_json)
      << ",\n \"groups\": " << jsonObject(table.groups, to_json)
      << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

/// JSON is YAML.
std::string pointOf(const Eigen::Vector3d& point) {
  return "{x: " + exactNumber(point.x()) + ", y: " + exactNumber(point.y()) +
         ", z: " + exactNumber(point.z()) + "}";
}

/// The edges of a box, as LINE_LIST.
void writeMarker(const ReachTable& table, const std::string& name, const Reach& reach,
                 std::size_t id, const std::string& look, std::ostream& out) {
  const std::array<Eigen::Vector3d, 8> points = corners(reach.box());
  const auto end = [&](int number) { return pointOf(points[static_cast<std::size_t>(number)]); };
  const auto line = [&](const auto& edge) { return joined(edge, ", ", end); };
  out << "- {header: {frame_id: " << jsonString(table.frame) << "}, ns: " << jsonString(name)
      << ", id: " << id << ", type: 5, pose: {orientation: {w: 1}}, scale: " << look
      << ",\n   points: [" << joined(edges(), ", ", line) << "]}\n";
}

}  // namespace

void write(const ReachTable& table, Format format, std::ostream& out) {
  writerFor<ReachTable>(format, writeTable, writeCsv, writeJson)(table, out);
}

void writeMarkers(const ReachTable& table, std::ostream& out) {
  std::size_t id = 0;
  out << (table.links.empty() ? "markers: []\n" : "markers:\n");
  for (const auto& [name, reach] : table.links)
    writeMarker(table, name, reach, id++, kThin, out);
  for (const auto& [name, reach] : table.groups)
    writeMarker(table, name, reach, id++, kThick, out);
  for (const auto& [name, reason] : table.incomplete)
    out << "# incomplete: " << printable(name) << ": " << printable(reason) << '\n';
}

}  // namespace link_bounds
