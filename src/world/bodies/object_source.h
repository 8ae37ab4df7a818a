// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Turns markers of any publisher into objects: adds, replaces, deletes, refuses or ignores them.
#pragma once

#include <visualization_msgs/Marker.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "robot/mesh/erase_dead.h"
#include "world/bodies/live_objects.h"
#include "world/log/refusal_log.h"

namespace link_bounds {

/// Nodes like this one draw boxes of objects in namespaces with this prefix, which are ignored
/// here. A DELETEALL in such a namespace only removes objects of its sender.
constexpr char kDrawingsNamespace[] = "link_bounds/";

inline bool isDrawing(const visualization_msgs::Marker& marker) {
  return marker.ns.compare(0, sizeof(kDrawingsNamespace) - 1, kDrawingsNamespace) == 0;
}

/// A mesh that objects wait for.
struct MeshRequest {
  std::string uri;
  std::weak_ptr<const std::string> use;  ///< once this expires, nobody waits for the mesh
  std::uint64_t number = 0;              ///< increases with each request
};

/// Runs on the update thread. Requests meshes by `request_mesh`, which returns at once; the mesh,
/// or the reason why there is none, comes back through fillMesh(). Functions return true if a box,
/// a stamp or an incomplete name changed.
class ObjectSource {
 public:
  ObjectSource(LiveObjects& objects, std::function<void(const MeshRequest&)> request_mesh);

  /// Moves the points of a list out of the marker.
  bool take(visualization_msgs::Marker&& marker, const std::string& publisher, ros::Time now);

  /// Ignores answers to any but the last request for a mesh: the file may have changed since.
  bool fillMesh(const MeshRequest& request, const LoadedMesh& mesh, ros::Time now);

  /// Logs objects whose transform did not come in time, or that are sent again and again without
  /// one.
  void warnOfGivenUp(ros::Time now);

  using Points = std::map<std::string, std::weak_ptr<const PointSet>>;  ///< of meshes, by URI

  /// Requests the meshes of all objects again: files may have been repaired or replaced. Objects
  /// whose mesh is not in `unchanged` keep the box of the old file and are incomplete until the new
  /// file is loaded. Lines that were logged may be logged again.
  bool reloadMeshes(const Points& unchanged, ros::Time now);

 private:
  /// A mesh; it has neither points nor an error while it loads the first time.
  struct Mesh {
    std::weak_ptr<const PointSet> points;
    std::string error;
    std::uint64_t request = 0;  ///< number of the pending request; 0: none
    bool has_changed = false;   ///< the file has changed since the points were read
    std::weak_ptr<const std::string> use;
  };

  ObjectContent contentOf(const ObjectKey& key, visualization_msgs::Marker&& marker,
                          const std::string& publisher);
  void useMesh(ObjectContent& content);
  void warn(const LiveObject& object, const std::string& reason);
  void request(const std::string& uri, Mesh& mesh);

  LiveObjects& objects_;
  std::function<void(const MeshRequest&)> request_mesh_;
  std::uint64_t requests_ = 0;
  /// Names that nobody uses are forgotten now and then: a publisher may send any number of them.
  std::map<std::string, Mesh> meshes_;  ///< by URI
  std::size_t max_meshes_ = kManyMeshes;
  RefusalLog marker_log_{"the marker", "further markers"};
  RefusalLog mesh_log_{"the mesh", "meshes of further objects"};
};

}  // namespace link_bounds
