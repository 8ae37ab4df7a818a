// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/cloud/link_cells.h"

namespace link_bounds {

LinkCells::LinkCells(const ScanPoses& poses) {
  if (poses.box.isEmpty()) return;
  origin_ = poses.box.min();
  for (int k = 0; k < 3; ++k) {
    const double size = poses.box.sizes()[k];
    per_cell_[k] = size > 0 ? kCells / size : 0;
  }
  for (const LinkMotion& link : poses.links)
    forEachCell(link.box, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t i = 1; i < starts_.size(); ++i)
    starts_[i] += starts_[i - 1];
  links_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < poses.links.size(); ++i)
    forEachCell(poses.links[i].box, [&](std::size_t cell) { links_[next[cell]++] = i; });
}

template <class Visit>
void LinkCells::forEachCell(const Aabb& box, const Visit& visit) const {
  if (box.isEmpty()) return;
  for (std::size_t z = placeOf(2, box.min()[2]); z <= placeOf(2, box.max()[2]); ++z) {
    for (std::size_t y = placeOf(1, box.min()[1]); y <= placeOf(1, box.max()[1]); ++y) {
      for (std::size_t x = placeOf(0, box.min()[0]); x <= placeOf(0, box.max()[0]); ++x)
        visit(indexOf(x, y, z));
    }
  }
}

}  // namespace link_bounds
