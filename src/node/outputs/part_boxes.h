// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of the parts of links, computed only when a message needs them.
#pragma once

#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "node/scene/live_boxes.h"

namespace link_bounds {

class PartBoxes {
 public:
  void adopt(const Model& model);

  /// True if the model wants more than one part per link.
  bool areWanted() const { return are_wanted_; }

  /// Copies the states and poses of the links, if parts are wanted. The links must have the adopted
  /// model.
  void place(const LiveBoxes& links);

  /// Overwrites `message` with the parts of all links that had a box at the last place(), with
  /// name, stamp and incompleteness of the link. `model` is the adopted one.
  void fill(const Model& model, AxisAlignedBoxArray& message);

 private:
  bool are_wanted_ = false;
  std::vector<LinkBoxes> parts_;        ///< by link
  std::vector<BoxState> states_;        ///< by link, as its pose
  std::vector<Eigen::Affine3d> poses_;  ///< of links that have a box
};

}  // namespace link_bounds
