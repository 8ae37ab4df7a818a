// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes are computed in the frame of the report; other volumes in that of their link, then placed.
#include "tools/urdf_bounds/report.h"

#include <iostream>
#include <optional>
#include <utility>

#include "tools/urdf_bounds/terminal.h"
#include "tools/urdf_bounds/volume_table.h"

namespace link_bounds {
namespace {

/// Fills in the volume of each link that has one by `volume_of`, which returns an optional.
template <class Volume, class VolumeOf>
void fillTable(const std::vector<PlacedLink>& links, const VolumeOf& volume_of,
               std::vector<std::pair<std::string, Volume>>& volumes, Reasons& incomplete) {
  for (const PlacedLink& placed_link : links) {
    const BoundedLink& link = *placed_link.link;
    const std::optional<Volume> volume = volume_of(placed_link);
    if (volume) volumes.emplace_back(link.name, *volume);
    if (!link.isWhole()) {
      incomplete.emplace_back(link.name, link.missing);
    } else if (!volume) {
      incomplete.emplace_back(link.name, "its size and pose give no finite box");
      warn("link \"" + link.name + "\": " + incomplete.back().second);
    }
  }
}

Reasons writeBoxes(const UrdfBoundsOptions& options, const std::string& frame,
                   const std::vector<PlacedLink>& links) {
  BoxTable table;
  table.frame = frame;
  const auto box_of = [](const PlacedLink& link) {
    return linkBox(*link.link, Eigen::Affine3d(link.frame_from_link));
  };
  fillTable(links, box_of, table.boxes, table.incomplete);
  Aabb robot_box;
  for (const auto& named : table.boxes)
    robot_box.extend(named.second);
  if (!table.boxes.empty()) table.groups.emplace_back("robot", robot_box);
  writeBoxes(table, options.format, options.representation.value_or(Representation::kMinMax),
             std::cout);
  return table.incomplete;
}

template <class Volume>
Reasons writeVolumes(const UrdfBoundsOptions& options, const std::string& frame,
                     const std::vector<PlacedLink>& links,
                     std::optional<Volume> (*volume_of)(const BoundedLink&)) {
  VolumeTable<Volume> table;
  table.frame = frame;
  const auto placed_volume = [volume_of](const PlacedLink& link) {
    const std::optional<Volume> volume = volume_of(*link.link);
    return volume ? placed(*volume, link.frame_from_link) : std::nullopt;
  };
  fillTable(links, placed_volume, table.volumes, table.incomplete);
  writeVolumes(table, options.format, std::cout);
  return table.incomplete;
}

}  // namespace

Reasons writeReport(const UrdfBoundsOptions& options, const std::string& frame,
                    const std::vector<PlacedLink>& links) {
  switch (options.volume) {
    case VolumeKind::kBox:
      break;
    case VolumeKind::kSphere:
      return writeVolumes(options, frame, links, boundingSphere);
    case VolumeKind::kOrientedBox:
      return writeVolumes(options, frame, links, orientedBox);
  }
  return writeBoxes(options, frame, links);
}

}  // namespace link_bounds
