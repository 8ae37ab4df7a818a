// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The bounding spheres or oriented boxes of a robot as text: a table to read, CSV or JSON.
#pragma once

#include "link_bounds/geometry/volumes/bounding_sphere.h"
#include "link_bounds/geometry/volumes/oriented_box.h"
#include "tools/text/table_text.h"

namespace link_bounds {

/// All lengths in metres; centres and orientations in `frame`.
template <class Volume>
struct VolumeTable {
  std::string frame;
  std::vector<std::pair<std::string, Volume>> volumes;  ///< by link
  Reasons incomplete;
};

void writeVolumes(const VolumeTable<BoundingSphere>& table, Format format, std::ostream& out);
void writeVolumes(const VolumeTable<OrientedBox>& table, Format format, std::ostream& out);

}  // namespace link_bounds
