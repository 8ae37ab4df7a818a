// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// All bodies at one moment, with the content of ~boxes. Overlaps, parts, markers and distances are
// computed from it. The result of a request for past boxes is a Moment, too.
#pragma once

#include <std_msgs/Header.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/bodies/scene.h"

namespace link_bounds {

/// Keeps its model and objects alive. Once shared it never changes, so any thread may read it.
struct Moment {
  /// A link or an object that has a box.
  struct Body {
    std::optional<std::size_t> link;              ///< its index in the model
    std::shared_ptr<const ObjectContent> object;  ///< null for links
    std::int64_t stamp;                           ///< of the box [ns]
    Aabb box;                                     ///< in the frame of the header, with padding
    Eigen::Affine3d frame_from_body;  ///< pose for which the box was made; for a motion, its end
  };

  std::shared_ptr<const Model> model;
  std_msgs::Header header;                    ///< as in ~boxes
  std::vector<std::string> incomplete;        ///< as in ~boxes
  std::vector<std::size_t> incomplete_links;  ///< indices in the model, ascending
  std::vector<Body> bodies;                   ///< in the order of ~boxes

  const std::string& name(const Body& body) const {
    return body.link ? model->links[*body.link].name : body.object->bounded.name;
  }

  /// The body with this index, as an argument of isPair().
  PairMember member(std::size_t index) const { return {&name(bodies[index]), bodies[index].link}; }

  /// Adds a body to `incomplete`. To be called in the order of ~boxes, so that objects of the same
  /// name are successive and the name is added once.
  void addIncomplete(const std::string& name, std::optional<std::size_t> link);
};

using MomentPtr = std::shared_ptr<const Moment>;

/// The scene as it is now. It must have a model.
MomentPtr momentOf(const Scene& scene);

}  // namespace link_bounds
