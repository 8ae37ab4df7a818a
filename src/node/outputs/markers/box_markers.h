// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes as markers for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "world/moment/moment.h"

namespace link_bounds {

/// ADD markers for each box: faces (id 0), edges (id 1) and label (id 2), as the parameters
/// marker_style and marker_labels say. The namespace is the tf name of a link, or
/// "link_bounds/objects/<name>" for an object. Boxes that rviz cannot draw are left out.
visualization_msgs::MarkerArray boxMarkers(const Moment& moment);

/// Keeps the markers that rviz may show, so that the next array can delete those that no longer
/// exist.
class ShownMarkers {
 public:
  /// Appends a DELETE for each kept marker that is not in `markers`, then keeps the markers of
  /// `markers` instead. If an earlier array and its DELETEs may be lost (`has_lost`), puts a
  /// DELETEALL in front instead.
  void replaceBy(visualization_msgs::MarkerArray& markers, const std_msgs::Header& header,
                 bool has_lost = false);

  /// Keeps the markers of `markers` in addition.
  void add(const visualization_msgs::MarkerArray& markers);

 private:
  using Key = std::pair<std::string, int>;  ///< ns and id

  std::set<Key> shown_;
};

}  // namespace link_bounds
