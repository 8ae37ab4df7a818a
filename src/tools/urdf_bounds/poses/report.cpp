// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes are computed in the frame of the report; other volumes in that of their link, then placed.
#include "tools/urdf_bounds/poses/report.h"

#include <algorithm>
#include <iostream>

#include "tools/command_line/terminal.h"
#include "tools/urdf_bounds/poses/volume_table.h"

namespace link_bounds {
namespace {

template <class LinkVolume>
std::optional<Volume> placedVolume(const std::optional<LinkVolume>& volume,
                                   const Eigen::Isometry3d& frame_from_link) {
  if (!volume) return std::nullopt;
  const auto in_frame = placed(*volume, frame_from_link);
  if (!in_frame) return std::nullopt;
  return toVolume(*in_frame);
}

/// Of a box, `robot_box` is extended by it.
std::optional<Volume> volumeOf(const PlacedLink& link, const VolumeTable& table, Aabb& robot_box) {
  switch (table.kind) {
    case VolumeKind::kBox:
      break;
    case VolumeKind::kSphere:
      return placedVolume(boundingSphere(*link.link), link.frame_from_link);
    case VolumeKind::kOrientedBox:
      return placedVolume(orientedBox(*link.link), link.frame_from_link);
  }
  const std::optional<Aabb> box = linkBox(*link.link, Eigen::Affine3d(link.frame_from_link));
  if (!box) return std::nullopt;
  robot_box.extend(*box);
  return toVolume(*box, table.representation);
}

/// Warns of each. A link keeps the reason that it has.
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
                    const std::vector<PlacedLink>& links,
                    const std::optional<DistanceTable>& distances) {
  VolumeTable table;
  table.kind = options.volume;
  table.representation = options.representation.value_or(Representation::kMinMax);
  table.frame = frame;
  Aabb robot_box;
  for (const PlacedLink& placed_link : links) {
    const BoundedLink& link = *placed_link.link;
    const std::optional<Volume> volume = volumeOf(placed_link, table, robot_box);
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
