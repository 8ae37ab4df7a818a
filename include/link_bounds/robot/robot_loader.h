// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// From a robot description and its mesh files to the links that get a box.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/geometry/distance/body.h"
#include "link_bounds/geometry/shape/link_boxes.h"
#include "link_bounds/robot/mesh/mesh_store.h"
#include "link_bounds/robot/urdf/robot.h"
#include "link_bounds/robot/worker/mesh_process.h"

namespace link_bounds {

/// Which links are bounded, and by what.
struct Selection {
  bool visual = true;
  bool collision = false;
  std::vector<std::string> links;              ///< only these; empty: every link with geometry
  std::vector<std::string> ignore_links;       ///< none of these
  double padding = 0;                          ///< metres, finite, >= 0
  std::map<std::string, double> link_padding;  ///< replaces padding for that link
  int parts_per_link = 1;                      ///< max number of parts of a link, >= 1
  bool triangles = false;                      ///< whether BoundedRobot::bodies are made
};

/// Selects all links. `geometry` is "visual", "collision" or "both".
inline Selection selectionOf(const std::string& geometry) {
  Selection selection;
  selection.visual = geometry != "collision";
  selection.collision = geometry != "visual";
  return selection;
}

/// Where mesh files are found, and the limits of reading one.
struct MeshSource {
  PackagePath package_path = {};  ///< null: there are no packages
  std::string base_folder = {};   ///< for relative mesh names; "": these are refused
  LoadProgress progress = {};     ///< may be null
  MeshLimits limits = {};
  /// May be null. Called from several threads; true ends a load early.
  std::function<bool()> is_cancelled = {};
};

struct BoundedRobot {
  std::vector<BoundedLink> links;     ///< selected and with geometry, in the order of the URDF
  std::vector<std::size_t> indices;   ///< for each of `links`: its index in Robot::links
  std::vector<std::string> problems;  ///< one per element that is not bounded: link, element,
                                      ///< file, reason, remedy
  std::map<std::string, std::shared_ptr<const PointSet>> meshes;     ///< those in use, by real path
  std::map<std::string, std::shared_ptr<const PointSet>> mesh_uris;  ///< those in use, by URI as in
                                                                     ///< the URDF
  /// The parts of each link, with its name, padding and missing geometry; none for a link without
  /// shapes. Empty if parts_per_link is 1.
  std::vector<std::vector<BoundedLink>> parts;
  /// The input of distances: a body for each of `links`, in its frame and without padding, with the
  /// same shapes in the same order. All shapes of one mesh file share its triangles. Empty unless
  /// Selection::triangles is set.
  std::vector<Body> bodies;
  /// A message per link that is not split although parts were selected: splitting it takes too
  /// long.
  std::vector<std::string> part_problems;
  /// A message per mesh element that has no triangles in `bodies`, so that distances are those of
  /// its convex hull: link, element, file, reason, remedy.
  std::vector<std::string> body_problems;
};

/// A mesh file as distances need it.
struct LoadedTree {
  /// Points that are in use already, unless the file was replaced since; null if it cannot be read.
  std::shared_ptr<const PointSet> points;
  std::shared_ptr<const TriangleTree> triangles;  ///< null if it cannot be read or is too large
  std::string error;          ///< file, reason and remedy; "" if there are triangles
  bool is_cancelled = false;  ///< by MeshSource::is_cancelled
};

/// Loads the meshes of robots and of single objects. Owns the store of what has been read: as long
/// as points are in use, a further load shares them and reads only files that have changed. Any
/// number of threads may use it.
class RobotLoader {
 public:
  /// Each mesh file is read by a process of its own. `remedy` words what a user can do about a mesh
  /// that cannot be used.
  explicit RobotLoader(MeshRemedy remedy = plainRemedy);

  /// Mesh files are read by `importer`. MeshSource::limits do not apply to it. Meshes that it
  /// returns are checked.
  explicit RobotLoader(MeshImporter importer, MeshRemedy remedy = plainRemedy);

  RobotLoader(const RobotLoader&) = delete;
  RobotLoader& operator=(const RobotLoader&) = delete;

  /// Geometry that cannot be used throws nothing: its link is then incomplete.
  BoundedRobot load(const Robot& robot, const Selection& selection, const MeshSource& source);

  /// One result per mesh URI, in order; an error names the file, the reason and the remedy. Throws
  /// nothing but std::bad_alloc where not even the errors fit into memory.
  std::vector<LoadedMesh> loadMeshes(const std::vector<std::string>& uris,
                                     const MeshSource& source);

  /// As above. Reads each file again, even if its points are in use. The triangles of one mesh take
  /// at most source.limits.max_bytes, whatever imports it. Memory for reading does not depend on
  /// the number of files.
  std::vector<LoadedTree> loadTrees(const std::vector<std::string>& uris, const MeshSource& source);

  /// The points of that mesh, if they are in use and its file has not changed since it was read;
  /// else null.
  std::shared_ptr<const PointSet> find(const std::string& uri, const MeshSource& source) const;

  /// Files that could not be read are not read again until this call.
  void forgetFailures() { store_.forgetFailures(); }

 private:
  std::vector<LoadedMesh> loadAll(const std::vector<std::string>& uris, const MeshSource& source,
                                  MeshContent content);
  std::vector<LoadedMesh> loadResolved(const std::vector<std::string>& uris,
                                       const MeshSource& source, MeshContent content);
  std::string wording(const std::exception& error) const;

  MeshRemedy remedy_;
  MeshStore store_;
};

struct LoadedRobot {
  Robot robot;
  BoundedRobot bounded;
};

/// Parses the URDF and loads the meshes of the selected links, once. Throws RobotError if the text
/// cannot be used as a URDF; what is wrong with single elements is in BoundedRobot::problems.
LoadedRobot loadRobot(const std::string& urdf, const MeshSource& source,
                      const Selection& selection = {});

}  // namespace link_bounds
