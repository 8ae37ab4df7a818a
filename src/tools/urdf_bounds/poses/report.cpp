// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the volumes of a robot as a table, CSV or JSON; kinds of volumes differ only in their
// Words. Boxes are computed in the frame of the report, other volumes in the frame of their link
// and then moved.
#include <algorithm>
#include <iostream>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/volumes/bounding_sphere.h"
#include "link_bounds/geometry/volumes/oriented_box.h"
#include "tools/command_line/terminal.h"
#include "tools/formats/safe_text.h"
#include "tools/formats/table_text.h"
#include "tools/urdf_bounds/poses/reports.h"

namespace link_bounds {
namespace {

/// A volume of any kind, ready to be printed.
struct Volume {
  Numbers numbers;   ///< in the order of the columns
  std::string json;  ///< a JSON value
};

/// Lengths are in metres, coordinates in `frame`.
struct VolumeTable {
  using NamedVolume = std::pair<std::string, Volume>;

  VolumeKind kind = VolumeKind::kBox;
  Representation representation = Representation::kMinMax;  ///< for kBox
  std::string frame;
  std::vector<NamedVolume> volumes;  ///< of links, by name
  std::vector<NamedVolume> groups;   ///< for kBox: the robot
  std::optional<DistanceTable> distances;
  Reasons incomplete;
};

/// The texts that depend on the kind of volume.
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

Numbers numbersIn(const Aabb& box, Representation representation) {
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
  return numbersOf(box);
}

/// JSON of a box is always min-max.
Volume toVolume(const Aabb& box, Representation representation) {
  return {numbersIn(box, representation), "{" + jsonCorners(box) + "}"};
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

/// CSV has only one kind of rows, so it has only the distances if there are any.
void write(const VolumeTable& table, Format format, std::ostream& out) {
  using Writer = void (*)(const VolumeTable&, const Words&, std::ostream&);
  writerFor<Writer>(format, writeTable, writeCsv, writeJson)(table, wordsOf(table), out);
}

template <class LinkVolume>
std::optional<Volume> placedVolume(const std::optional<LinkVolume>& volume,
                                   const Eigen::Isometry3d& frame_from_link) {
  if (!volume) return std::nullopt;
  const auto in_frame = placed(*volume, frame_from_link);
  if (!in_frame) return std::nullopt;
  return toVolume(*in_frame);
}

/// The volume of a link in the frame of the report. If it is a box, extends `robot_box` by it.
std::optional<Volume> volumeOf(const BoundedLink& link, const Eigen::Isometry3d& frame_from_link,
                               const VolumeTable& table, Aabb& robot_box) {
  switch (table.kind) {
    case VolumeKind::kBox:
      break;
    case VolumeKind::kSphere:
      return placedVolume(boundingSphere(link), frame_from_link);
    case VolumeKind::kOrientedBox:
      return placedVolume(orientedBox(link), frame_from_link);
  }
  const std::optional<Aabb> box = linkBox(link, Eigen::Affine3d(frame_from_link));
  if (!box) return std::nullopt;
  robot_box.extend(*box);
  return toVolume(*box, table.representation);
}

/// Warns of each reason, and adds it unless its link already has one in `incomplete`.
void addReasons(const Reasons& reasons, Reasons& incomplete) {
  for (const auto& [link, reason] : reasons) {
    const auto has_name = [&name = link](const auto& known) { return known.first == name; };
    warn("link \"" + link + "\": " + reason);
    if (std::none_of(incomplete.begin(), incomplete.end(), has_name))
      incomplete.emplace_back(link, reason);
  }
}

}  // namespace

Reasons writeReport(const UrdfBoundsOptions& options, const std::string& frame,
                    const BoundedRobot& bounded, const std::vector<Eigen::Isometry3d>& poses,
                    const std::optional<DistanceTable>& distances) {
  VolumeTable table;
  table.kind = options.volume;
  table.representation = options.representation.value_or(Representation::kMinMax);
  table.frame = frame;
  Aabb robot_box;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const BoundedLink& link = bounded.links[i];
    const std::optional<Volume> volume =
        volumeOf(link, poses[bounded.indices[i]], table, robot_box);
    if (volume) table.volumes.emplace_back(link.name, *volume);
    if (!link.isWhole()) {
      table.incomplete.emplace_back(link.name, link.missing);
    } else if (!volume) {
      addReasons({{link.name, "its size and pose give no finite box"}}, table.incomplete);
    }
  }
  if (!robot_box.isEmpty())
    table.groups.emplace_back("robot", toVolume(robot_box, table.representation));
  table.distances = distances;
  if (distances) addReasons(distances->incomplete, table.incomplete);
  if (table.kind == VolumeKind::kBox) addIncompleteGroup(table.incomplete);
  write(table, options.format, std::cout);
  return table.incomplete;
}

}  // namespace link_bounds
