// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The question about each bag: a robot, zones and options.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "tools/bag_bounds/run/bag_bounds_options.h"
#include "tools/bag_bounds/watch/zones.h"
#include "world/model/model.h"

namespace link_bounds {

/// Reads the robot, its meshes and the zones once, for any number of bags.
class BagQuestion {
 public:
  /// Throws std::exception if the robot or the zones cannot be read or used, or if an output would
  /// overwrite an input. `options` must outlive this.
  explicit BagQuestion(const BagBoundsOptions& options);
  BagQuestion(const BagQuestion&) = delete;
  BagQuestion& operator=(const BagQuestion&) = delete;

  const std::shared_ptr<const Model>& model() const { return model_; }
  const std::vector<Zone>& zones() const { return zones_; }

  LoadedMesh loadMesh(const std::string& uri);
  LoadedTree loadTree(const std::string& uri);

  /// Reads the triangles of the robot in advance.
  void loadTrees();

  /// Equal for the same version, robot, meshes, zones and options, on any machine and with any file
  /// names. Includes the triangles only if loadTrees() has read them. Throws UsageError if a file
  /// cannot be read again.
  std::string fingerprint() const;

 private:
  Model makeModelOf(const std::string& urdf);

  const BagBoundsOptions& options_;
  MeshSource mesh_source_;
  RobotLoader loader_;
  std::string zones_text_;
  std::vector<Zone> zones_;
  std::string urdf_;
  std::shared_ptr<const Model> model_;
  std::map<std::string, LoadedTree> trees_;  ///< by mesh URI
};

}  // namespace link_bounds
