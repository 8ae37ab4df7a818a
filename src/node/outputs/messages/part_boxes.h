// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of the parts of links. They are computed only when a message needs them.
#pragma once

#include <memory>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "world/moment/moment.h"

namespace link_bounds {

class PartBoxes {
 public:
  /// Overwrites `message` with the parts of all links that have a box; a part has the name, stamp
  /// and incompleteness of its link. False if parameter parts_per_link is 1.
  bool fill(const Moment& moment, AxisAlignedBoxArray& message);

 private:
  void adopt(std::shared_ptr<const Model> model);

  std::shared_ptr<const Model> model_;
  std::vector<LinkBoxes> parts_;  ///< index = link
};

}  // namespace link_bounds
