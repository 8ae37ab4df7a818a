// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All bodies at one moment: what ~boxes says. Overlaps, parts, markers and distances follow from
// it, and boxes of the past are one, too.
#pragma once

#include <std_msgs/Header.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"

namespace link_bounds {

/// Holds what it needs alive. Once shared it never changes, so any thread may read it.
struct Moment {
  /// A link or an object that has a box.
  struct Body {
    std::optional<std::size_t> link;              ///< its index in the model
    std::shared_ptr<const ObjectContent> object;  ///< null for links
    std::int64_t stamp;                           ///< of the box [ns]
    Aabb box;                                     ///< in the frame of the header, with padding
    Eigen::Affine3d frame_from_body;  ///< the pose of the box; of a motion, the last one
  };

  std::shared_ptr<const Model> model;
  std_msgs::Header header;                    ///< that of the message of boxes
  std::vector<std::string> incomplete;        ///< that of the message of boxes
  std::vector<std::size_t> incomplete_links;  ///< indices in the model, rising
  std::vector<Body> bodies;                   ///< in the order of ~boxes

  const std::string& name(const Body& body) const {
    return body.link ? model->links[*body.link].name : body.object->bounded.name;
  }

  /// The body of that index, as isPair() takes it.
  PairMember member(std::size_t index) const { return {&name(bodies[index]), bodies[index].link}; }

  /// Adds the next body to those that are incomplete. Objects of one name follow each other.
  void addIncomplete(const std::string& name, std::optional<std::size_t> link);
};

using MomentPtr = std::shared_ptr<const Moment>;

/// The scene as it is. There must be a model.
MomentPtr momentOf(const Scene& scene);

}  // namespace link_bounds
