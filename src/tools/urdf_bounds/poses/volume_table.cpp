// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One writer per format; the kinds of volumes differ in their words only.
#include "tools/urdf_bounds/poses/volume_table.h"

#include <algorithm>

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

/// The words of a kind of volume.
struct Words {
  std::string title;
  Row columns;  ///< the first is the name
  std::string csv_head;
  const char* json;
  const char* none;
};

Words wordsOfBoxes(Representation representation) {
  Words words{"representation: ", {"link"}, "link,a_x,a_y,a_z,b_x,b_y,b_z", "boxes", "box"};
  const auto add = [&](const char* title, const char* a, const char* b) {
    words.title += title;
    for (const std::string vector : {a, b}) {
      for (const char* axis : {" x", " y", " z"})
        words.columns.push_back(vector + axis);
    }
  };
  switch (representation) {
    case Representation::kMinMax:
      add("min-max", "min", "max");
      break;
    case Representation::kMinWidth:
      add("min-width", "min", "width");
      break;
    case Representation::kCenterRadius:
      add("center-radius", "center", "radius");
      break;
  }
  return words;
}

Words wordsOf(const VolumeTable& table) {
  switch (table.kind) {
    case VolumeKind::kBox:
      break;
    case VolumeKind::kSphere:
      return {"volume: sphere",
              {"link", "center x", "center y", "center z", "radius"},
              "link,center_x,center_y,center_z,radius",
              "spheres",
              "volume"};
    case VolumeKind::kOrientedBox:
      return {"volume: oriented box",
              {"link", "center x", "center y", "center z", "size x", "size y", "size z", "q x",
               "q y", "q z", "q w"},
              "link,center_x,center_y,center_z,size_x,size_y,size_z,q_x,q_y,q_z,q_w",
              "oriented_boxes",
              "volume"};
  }
  return wordsOfBoxes(table.representation);
}

void writeTable(const VolumeTable& table, const Words& words, std::ostream& out) {
  out << "frame: " << printable(table.frame) << "    unit: m    " << words.title << "\n\n";
  std::vector<Row> rows{words.columns};
  for (const auto& [name, volume] : table.volumes)
    rows.push_back(shortRow(printable(name), volume.numbers));
  for (const auto& [name, volume] : table.groups)
    rows.push_back(shortRow(kGroupPrefix + name, volume.numbers));
  writeAligned(rows, out);
  if (table.volumes.empty()) out << "(no link has a " << words.none << ")\n";
  if (table.distances) {
    out << '\n';
    writeTable(*table.distances, out);
  }
  writeIncomplete(table.incomplete, out);
}

void writeCsv(const VolumeTable& table, const Words& words, std::ostream& out) {
  if (table.distances) return writeCsv(*table.distances, out);
  out << words.csv_head << '\n';
  for (const auto& [name, volume] : table.volumes)
    writeCsvRow(name, volume.numbers, out);
  for (const auto& [name, volume] : table.groups)
    writeCsvRow(kGroupPrefix + name, volume.numbers, out);
  const auto commas = std::count(words.csv_head.begin(), words.csv_head.end(), ',');
  writeCsvIncomplete(table.incomplete, static_cast<std::size_t>(commas), out);
}

void writeJson(const VolumeTable& table, const Words& words, std::ostream& out) {
  const auto to_json = [](const Volume& volume) { return volume.json; };
  out << "{\"frame\": " << jsonString(table.frame) << ",\n \"" << words.json
      << "\": " << jsonObject(table.volumes, to_json);
  if (table.kind == VolumeKind::kBox)
    out << ",\n \"groups\": " << jsonObject(table.groups, to_json);
  if (table.distances) out << ",\n \"distances\": " << toJson(*table.distances);
  out << ",\n \"incomplete\": " << jsonObject(table.incomplete, jsonString) << "}\n";
}

Numbers numbersOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

Numbers numbersOf(const Aabb& box, Representation representation) {
  switch (representation) {
    case Representation::kMinMax:
      break;
    case Representation::kMinWidth:
      return numbersOf(box.min(), toMinWidth(box).width);
    case Representation::kCenterRadius: {
      const CenterRadius form = toCenterRadius(box);
      return numbersOf(form.center, form.radius);
    }
  }
  return numbersOf(box.min(), box.max());
}

}  // namespace

Volume toVolume(const Aabb& box, Representation representation) {
  return {numbersOf(box, representation),
          "{\"min\": " + jsonNumbers(box.min()) + ", \"max\": " + jsonNumbers(box.max()) + "}"};
}

Volume toVolume(const BoundingSphere& sphere) {
  const Eigen::Vector3d& c = sphere.center;
  return {{c.x(), c.y(), c.z(), sphere.radius},
          "{\"center\": " + jsonNumbers(c) + ", \"radius\": " + exactNumber(sphere.radius) + "}"};
}

Volume toVolume(const OrientedBox& box) {
  const Eigen::Quaterniond& q = box.orientation;
  Numbers numbers = numbersOf(box.center, box.size);
  numbers.insert(numbers.end(), {q.x(), q.y(), q.z(), q.w()});
  return {numbers, "{\"center\": " + jsonNumbers(box.center) +
                       ", \"size\": " + jsonNumbers(box.size) +
                       ", \"orientation\": " + jsonNumbers(q.coeffs()) + "}"};
}

void write(const VolumeTable& table, Format format, std::ostream& out) {
  const Words words = wordsOf(table);
  switch (format) {
    case Format::kTable:
      return writeTable(table, words, out);
    case Format::kCsv:
      return writeCsv(table, words, out);
    case Format::kJson:
      return writeJson(table, words, out);
  }
}

}  // namespace link_bounds
