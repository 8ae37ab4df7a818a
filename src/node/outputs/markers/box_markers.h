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

/// An ADD per marker of each box: faces (id 0), edges (id 1) and label (id 2), as marker_style and
/// marker_labels of the model say. The namespace is the tf name of a link, or
/// "link_bounds/objects/<name>" for an object. Boxes that rviz cannot draw are left out.
visualization_msgs::MarkerArray boxMarkers(const Moment& moment);

/// Remembers the markers that rviz may show, so that each array can delete those that are gone.
class ShownMarkers {
 public:
  /// Appends a DELETE for each remembered marker that `markers` lacks, then remembers only those of
  /// `markers`. If an earlier array may be lost, with its DELETEs, it puts a DELETEALL in front
  /// instead.
  void replaceBy(visualization_msgs::MarkerArray& markers, const std_msgs::Header& header,
                 bool has_lost = false);

  /// Remembers those of `markers`, too.
  void add(const visualization_msgs::MarkerArray& markers);

 private:
  using Key = std::pair<std::string, int>;  ///< ns and id

  std::set<Key> shown_;
};

}  // namespace link_bounds
