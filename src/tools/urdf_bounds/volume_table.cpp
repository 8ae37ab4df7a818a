// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The names and numbers of each kind of volume; the formats are shared.
#include "tools/urdf_bounds/volume_table.h"

namespace link_bounds {
namespace {

Numbers numbersOf(const BoundingSphere& sphere) {
  const Eigen::Vector3d& c = sphere.center;
  return {c.x(), c.y(), c.z(), sphere.radius};
}

Numbers numbersOf(const OrientedBox& box) {
  const Eigen::Vector3d& c = box.center;
  const Eigen::Quaterniond& q = box.orientation;
  return {c.x(),        c.y(), c.z(), box.size.x(), box.size.y(),
          box.size.z(), q.x(), q.y(), q.z(),        q.w()};
}

std::string jsonValue(const BoundingSphere& sphere) {
  return "{\"center\": " + jsonNumbers(sphere.center) +
         ", \"radius\": " + exactNumber(sphere.radius) + "}";
}

std::string jsonValue(const OrientedBox& box) {
  return "{\"center\": " + jsonNumbers(box.center) + ", \"size\": " + jsonNumbers(box.size) +
         ", \"orientation\": " + jsonNumbers(box.orientation.coeffs()) + "}";
}

/// The names of a kind of volume; its columns are those of numbersOf.
struct Names {
  const char* volume;
  const char* json;
  Row columns;
};

const Names kSphereNames{
    "sphere", "spheres", {"link", "center x", "center y", "center z", "radius"}};
const Names kBoxNames{"oriented box",
                      "oriented_boxes",
                      {"link", "center x", "center y", "center z", "size x", "size y", "size z",
                       "q x", "q y", "q z", "q w"}};

template <class Volume>
void writeTable(const VolumeTable<Volume>& table, const Names& names, std::ostream& out) {
  out << "frame: " << printable(table.frame) << "    unit: m    volume: " << names.volume << "\n\n";
  std::vector<Row> rows{names.columns};
  for (const auto& [name, volume] : table.volumes)
    rows.push_back(shortRow(printable(name), numbersOf(volume)));
  writeAligned(rows, out);
  if (table.volumes.empty()) out << "(no link has a volume)\n";
  writeIncomplete(table.incomplete, out);
}

template <class Volume>
void writeCsv(const VolumeTable<Volume>& table, const Names& names, std::ostream& out) {
  std::string head;
  for (const std::string& column : names.columns)
    head += (head.empty() ? "" : ",") + column;
  for (char& c : head)
    if (c == ' ') c = '_';
  out << head << '\n';
  for (const auto& [name, volume] : table.volumes)
    writeCsvRow(name, numbersOf(volume), out);
}

template <class Volume>
void writeJson(const VolumeTable<Volume>& table, const Names& names, std::ostream& out) {
  const auto to_json = [](const Volume& volume) { return jsonValue(volume); };
  out << "{\"frame\": " << jsonString(table.frame) << ",\n \"" << names.json
      << "\": " << jsonObject(table.volumes, to_json)
      << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

template <class Volume>
void write(const VolumeTable<Volume>& table, const Names& names, Format format, std::ostream& out) {
  switch (format) {
    case Format::kTable:
      return writeTable(table, names, out);
    case Format::kCsv:
      return writeCsv(table, names, out);
    case Format::kJson:
      return writeJson(table, names, out);
  }
}

}  // namespace

void writeVolumes(const VolumeTable<BoundingSphere>& table, Format format, std::ostream& out) {
  write(table, kSphereNames, format, out);
}

void writeVolumes(const VolumeTable<OrientedBox>& table, Format format, std::ostream& out) {
  write(table, kBoxNames, format, out);
}

}  // namespace link_bounds
