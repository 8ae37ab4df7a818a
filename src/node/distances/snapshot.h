// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All bodies at one moment, for another thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "node/scene/scene.h"

namespace link_bounds {

/// A link or an object that has a box.
struct SnapshotBody {
  std::optional<std::size_t> link;              ///< its index in the model
  std::shared_ptr<const ObjectContent> object;  ///< null for links
  std::int64_t stamp;                           ///< of the box [ns]
  Aabb box;                                     ///< in the fixed frame, with padding
  Eigen::Affine3d fixed_from_body;              ///< the pose of the box
};

/// Holds what it needs alive and is never changed.
struct Snapshot {
  std::shared_ptr<const Model> model;
  std_msgs::Header header;              ///< that of ~boxes
  std::vector<std::string> incomplete;  ///< that of ~boxes
  std::vector<SnapshotBody> bodies;     ///< in the order of ~boxes
};

/// `boxes` is the message of this scene.
std::shared_ptr<const Snapshot> takeSnapshot(const Scene& scene, const AxisAlignedBoxArray& boxes);

}  // namespace link_bounds
