// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All bodies at one moment, for another thread.
#pragma once

#include <std_msgs/Header.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"

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
  std_msgs::Header header;                    ///< that of ~boxes
  std::vector<std::string> incomplete;        ///< that of ~boxes
  std::vector<std::size_t> incomplete_links;  ///< indices in the model, rising
  std::vector<SnapshotBody> bodies;           ///< in the order of ~boxes

  const std::string& name(const SnapshotBody& body) const {
    return body.link ? model->links[*body.link].name : body.object->bounded.name;
  }

  /// Of the body of that index.
  PairMember member(std::size_t index) const { return {&name(bodies[index]), bodies[index].link}; }
};

/// There must be a model.
std::shared_ptr<const Snapshot> takeSnapshot(const Scene& scene);

}  // namespace link_bounds
