// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes as markers for rviz.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "node/scene/scene.h"

namespace link_bounds {

/// An ADD per marker of each box: faces (id 0), edges (id 1) and label (id 2), as marker_style and
/// marker_labels of the model say. The namespace is the tf name of a link, or
/// "link_bounds/objects/<name>" for an object. Boxes that rviz cannot draw are left out.
visualization_msgs::MarkerArray boxMarkers(const Scene& scene, const std_msgs::Header& header);

/// Remembers the markers that rviz may show, so that each array can delete those that are gone.
class ShownMarkers {
 public:
  /// For an array that goes to all subscribers: appends a DELETE for each remembered marker that
  /// `markers` lacks, then remembers only those of `markers`.
  void replaceBy(visualization_msgs::MarkerArray& markers, const std_msgs::Header& header);

  /// For an array that goes to one subscriber: appends the same, but forgets nothing.
  void extendBy(visualization_msgs::MarkerArray& markers, const std_msgs::Header& header);

 private:
  using Key = std::pair<std::string, int>;  ///< ns and id

  std::set<Key> appendDeletions(visualization_msgs::MarkerArray& markers,
                                const std_msgs::Header& header) const;

  std::set<Key> shown_;
};

}  // namespace link_bounds
