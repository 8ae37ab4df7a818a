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

/// All boxes that exist as ADD: faces (id 0), edges (id 1) and label (id 2) as the model's
/// marker_style and marker_labels say; ns is the tf name of a link, "link_bounds/objects/<name>" of
/// an object. Boxes farther out than rviz's float32 can draw are left out.
visualization_msgs::MarkerArray boxMarkers(const Scene& scene, const std_msgs::Header& header);

/// Remembers what rviz may be showing, so that every array can delete what is gone.
class ShownMarkers {
 public:
  /// Appends a DELETE for each marker shown before that `markers` lacks, then remembers those of
  /// `markers` only: to be used for an array that goes to all subscribers.
  void replaceBy(visualization_msgs::MarkerArray& markers, const std_msgs::Header& header);

  /// Appends the same, but forgets nothing: for an array that goes to one subscriber.
  void extendBy(visualization_msgs::MarkerArray& markers, const std_msgs::Header& header);

 private:
  using Key = std::pair<std::string, int>;  ///< ns and id

  std::set<Key> appendDeletions(visualization_msgs::MarkerArray& markers,
                                const std_msgs::Header& header) const;

  std::set<Key> shown_;
};

}  // namespace link_bounds
