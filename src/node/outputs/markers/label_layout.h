// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Size, place and color of text in rviz.
#pragma once

#include <std_msgs/ColorRGBA.h>

#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// Magenta of a medium luminance, 0.19: contrast 4 to white, 3 to rviz's dark grey, 5 to black. Few
/// robots have this color.
std_msgs::ColorRGBA labelColor();

/// A line of text that faces the camera, so it takes its width along x and along y.
struct Label {
  Eigen::Vector3d bottom;  ///< the middle of its lower edge [m]
  double width;            ///< at most [m]; depends on the font
  double height;           ///< [m]
};

/// The label of a box grows with the box and is at most as wide as its diagonal. It stands above
/// the corner of largest x and y, where other links rarely hide it.
Label labelOf(const Aabb& box, const std::string& text);

/// Puts each label that overlaps a lower one on top of that one, like lines of a list. Of many
/// labels at one place, only some tens are kept apart, so that the time grows with their number and
/// not with its square.
void separate(std::vector<Label>& labels);

}  // namespace link_bounds
