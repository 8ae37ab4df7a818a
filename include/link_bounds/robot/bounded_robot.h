// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// From a robot description to the links that get a box.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/geometry/shape/link_boxes.h"
#include "link_bounds/robot/mesh/mesh_store.h"
#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Which links are bounded, and by what.
struct Selection {
  bool visual = true;
  bool collision = false;
  std::vector<std::string> links;              ///< only these; empty: every link with geometry
  std::vector<std::string> ignore_links;       ///< none of these
  double padding = 0;                          ///< metres, >= 0
  std::map<std::string, double> link_padding;  ///< replaces padding for that link
  int parts_per_link = 1;  ///< at most so many parts are made of each link, >= 1
};

/// Where the meshes of a robot are found.
struct MeshSource {
  PackagePath package_path;
  std::string base_folder;  ///< of relative mesh names; "" = they are refused
  LoadProgress progress;    ///< may be null
};

struct BoundedRobot {
  std::vector<BoundedLink> links;     ///< selected and with geometry, in the order of the URDF
  std::vector<std::string> problems;  ///< one per element that is not bounded: link, element,
                                      ///< file, reason, remedy
  std::map<std::string, std::shared_ptr<const PointSet>> meshes;  ///< those in use, by real path
  /// Of each link its parts, named, padded and missing something as the link is; none of a link
  /// without shapes. Empty if there is to be one per link: that is the link.
  std::vector<std::vector<BoundedLink>> parts;
};

/// Loads every mesh that is needed. Never throws for bad geometry: that link is then not whole.
BoundedRobot boundRobot(const Robot& robot, const Selection& selection, const MeshSource& source,
                        MeshStore& store);

}  // namespace link_bounds
