// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The objects of the storm: a grid of cubes of which some move, lists that change, and meshes that
// are replaced by others.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>
#include <vector>

namespace link_bounds {

/// Each function gives what is to be sent next. Everything follows its frame.
class StormScene {
 public:
  /// `meshes` are URIs.
  StormScene(std::size_t links, std::vector<std::string> meshes);

  visualization_msgs::MarkerArray allCubes();
  visualization_msgs::MarkerArray nextCubes();
  visualization_msgs::MarkerArray nextList();
  visualization_msgs::MarkerArray nextMesh();

  /// The newest state of each object, for a node that has seen nothing of the storm.
  visualization_msgs::MarkerArray everything() const;

 private:
  visualization_msgs::Marker marker(const std::string& ns, int id, int type, double x, double y,
                                    double z) const;
  visualization_msgs::Marker cube(int id) const;
  visualization_msgs::MarkerArray keep(const std::vector<visualization_msgs::Marker>& markers);

  std::size_t links_;
  std::vector<std::string> meshes_;
  std::size_t step_ = 0;
  std::map<std::string, visualization_msgs::Marker> newest_;  ///< by namespace and number
};

}  // namespace link_bounds
