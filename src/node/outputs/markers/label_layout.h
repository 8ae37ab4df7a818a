// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Size, position and color of text in rviz.
#pragma once

#include <std_msgs/ColorRGBA.h>

#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// Magenta with a medium luminance of 0.19. Its contrast ratio is 4 to white, 3 to rviz's dark grey
/// and 5 to black. Few robots have this color.
std_msgs::ColorRGBA labelColor();

/// A line of text that faces the camera. Its width is therefore reserved along both x and y.
struct Label {
  Eigen::Vector3d bottom;  ///< middle of the lower edge [m]
  double width;            ///< max width [m]; the real one depends on the font
  double height;           ///< [m]
};

/// The label of a box grows with the box and is at most as wide as the diagonal of the box. It
/// stands above the corner with the max x and y, where other links rarely hide it.
Label labelOf(const Aabb& box, const std::string& text);

/// Puts each label that overlaps a lower one on top of it, like lines of a list. If many labels are
/// at one place, only some tens of them are kept apart, so that the time grows linearly with their
/// number.
void separate(std::vector<Label>& labels);

}  // namespace link_bounds
