// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The update thread's data about the robot: made by each load, then never changed.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/box_groups.h"
#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/overlap_filter.h"
#include "world/model/object_key.h"
#include "world/model/parameters.h"

namespace link_bounds {

/// A group whose members are links, single objects, and all objects of a namespace.
struct SceneGroup : BoxGroup {
  std::vector<ObjectKey> objects;
  std::vector<std::string> namespaces;
};

/// Objects that are part of a rigid body.
struct Attachment {
  std::string objects;  ///< a name, or a pattern of names
  std::size_t body;     ///< number as in RigidBodies::of_links
};

struct Model {
  Parameters parameters;
  std::string fixed_frame;                      ///< tf name
  std::vector<BoundedLink> links;               ///< in the order of the URDF
  std::vector<std::string> frames;              ///< tf name of each link
  std::vector<std::vector<BoundedLink>> parts;  ///< by link; see BoundedRobot
  std::vector<SceneGroup> groups;  ///< "robot", then those of the user by name; members index links
  RigidBodies bodies;              ///< of the links, by index in `links`
  std::shared_ptr<const Robot> robot;    ///< all links and joints; null without a description
  std::vector<std::size_t> robot_links;  ///< by index in `links`: index in `robot`
  NamePairs ignored_pairs;               ///< their overlaps and distances are not published
  std::vector<Attachment> attached;      ///< the first one that matches an object counts
  std::map<std::string, std::size_t> mesh_bytes;  ///< memory of each mesh file in use
  std::map<std::string, std::shared_ptr<const PointSet>> mesh_uris;  ///< points in use, by URI
  /// Meshes of objects, by URI: points whose file had not changed since it was read, when the model
  /// was made.
  std::map<std::string, std::weak_ptr<const PointSet>> object_meshes;
  std::string left_out;               ///< see leftOutNote()
  std::vector<std::string> problems;  ///< one per element that is not bounded
  std::vector<std::string> warnings;  ///< e.g. names in parameters that fit no link
};

/// The name of a link in tf. Slashes at the ends of the prefix and one at the start of the link's
/// name are stripped; a link name that begins with a slash takes no prefix.
std::string tfName(const std::string& tf_prefix, const std::string& link);

/// The selection without the settings of parts and triangles.
Selection selectionOf(const LinkParameters& parameters);

/// One warning per link name in parameters that the robot does not have. `others`: further names,
/// each with its parameter.
std::vector<std::string> unknownLinks(const LinkParameters& parameters,
                                      const std::set<std::string>& links,
                                      const std::map<std::string, std::string>& others = {});

std::set<std::string> linkNames(const Robot& robot);

/// A model for objects only, as long as there is no description. The parameters must name the fixed
/// frame.
Model modelWithoutRobot(const Parameters& parameters);

/// Loads meshes of package:// and file:// URIs, within the limits of the parameters.
MeshSource meshSource(const Parameters& parameters);

/// Parses the description and loads its meshes from `source`. Throws RobotError, ParameterError.
Model makeModel(const std::string& description, const Parameters& parameters, RobotLoader& loader,
                const MeshSource& source);

/// A link or an object.
struct PairMember {
  const std::string* name;
  std::optional<std::size_t> link;  ///< index in the model; nothing for objects
};

/// The rigid body of a link, or of an object that is attached to one.
std::optional<std::size_t> bodyOf(const Model& model, const PairMember& member);

/// Whether overlaps and distances of the two are published: they are neither joined nor ignored.
bool isPair(const Model& model, const PairMember& a, const PairMember& b);

}  // namespace link_bounds
