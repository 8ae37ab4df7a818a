// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The volumes of a robot as text: a table to read, CSV or JSON.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/volumes/bounding_sphere.h"
#include "link_bounds/geometry/volumes/oriented_box.h"
#include "tools/formats/table_text.h"
#include "tools/urdf_bounds/poses/distance_table.h"
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

/// A volume of any kind in its text forms.
struct Volume {
  Numbers numbers;   ///< in the order of the columns
  std::string json;  ///< a value
};

/// JSON of a box is always min-max.
Volume toVolume(const Aabb& box, Representation representation);
Volume toVolume(const BoundingSphere& sphere);
Volume toVolume(const OrientedBox& box);

/// All lengths in metres, in `frame`.
struct VolumeTable {
  using NamedVolume = std::pair<std::string, Volume>;

  VolumeKind kind = VolumeKind::kBox;
  Representation representation = Representation::kMinMax;  ///< of kBox
  std::string frame;
  std::vector<NamedVolume> volumes;  ///< by link
  std::vector<NamedVolume> groups;   ///< of kBox
  std::optional<DistanceTable> distances;
  Reasons incomplete;
};

/// CSV, which has one kind of rows, is of the distances alone if there are any.
void write(const VolumeTable& table, Format format, std::ostream& out);

}  // namespace link_bounds
