// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// From markers of any publisher to objects: what is added, replaced, deleted, refused or ignored.
#pragma once

#include <link_bounds/AxisAlignedBoxArray.h>
#include <visualization_msgs/Marker.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "robot/mesh/erase_dead.h"
#include "world/bodies/live_objects.h"
#include "world/bodies/neighbour_sets.h"
#include "world/log/refusal_log.h"

namespace link_bounds {

/// Nodes like this one draw boxes of objects in namespaces with this prefix, which are ignored
/// here. A DELETEALL in one is for what its sender has drawn.
constexpr char kDrawingsNamespace[] = "link_bounds/";

inline bool isDrawing(const visualization_msgs::Marker& marker) {
  return marker.ns.compare(0, sizeof(kDrawingsNamespace) - 1, kDrawingsNamespace) == 0;
}

/// A mesh that objects wait for.
struct MeshRequest {
  std::string uri;
  std::weak_ptr<const std::string> use;  ///< once it has gone, nobody waits for the mesh
  std::uint64_t number = 0;              ///< the later, the larger
};

/// Runs on the update thread. Requests meshes by `request_mesh`, which returns at once; the mesh,
/// or why there is none, comes back through fillMesh(). Functions return true if a box, a stamp or
/// an incomplete name changed.
class ObjectSource {
 public:
  ObjectSource(LiveObjects& objects, std::function<void(const MeshRequest&)> request_mesh);

  /// Moves the points of a list out of the marker.
  bool take(visualization_msgs::Marker&& marker, const std::string& publisher, ros::Time now);

  /// ~boxes of another node.
  bool takeNeighbour(const AxisAlignedBoxArray& boxes, const NeighbourSender& sender,
                     ros::Time now) {
    return neighbours_.take(boxes, sender, now);
  }

  /// To be called now and then: removes the boxes of nodes that have ended.
  bool removeEndedNeighbours(ros::SteadyTime now, const HasLeft& has_left) {
    return neighbours_.removeEnded(now, has_left);
  }

  /// An answer to an earlier request than the last one of the mesh does not count: the file may
  /// have changed since.
  bool fillMesh(const MeshRequest& request, const LoadedMesh& mesh, ros::Time now);

  /// Logs which objects waited for a transform that did not come, or wait again and again.
  void warnOfGivenUp(ros::Time now);

  using Points = std::map<std::string, std::weak_ptr<const PointSet>>;  ///< of meshes, by URI

  /// Requests the meshes of all objects again: files may have been repaired or replaced. Those that
  /// are not `unchanged` keep the boxes of the old file and are incomplete until the new one is
  /// there. What was logged may be logged again.
  bool reloadMeshes(const Points& unchanged, ros::Time now);

 private:
  /// A mesh; it has neither points nor an error while it loads the first time.
  struct Mesh {
    std::weak_ptr<const PointSet> points;
    std::string error;
    std::uint64_t request = 0;  ///< the number of the one that is not answered yet; 0: none
    bool has_changed = false;   ///< its file, since the points were read
    std::weak_ptr<const std::string> use;
  };

  ObjectContent contentOf(const ObjectKey& key, visualization_msgs::Marker&& marker,
                          const std::string& publisher);
  void useMesh(ObjectContent& content);
  void warn(const LiveObject& object, const std::string& reason);
  void request(const std::string& uri, Mesh& mesh);

  LiveObjects& objects_;
  NeighbourSets neighbours_{objects_};
  std::function<void(const MeshRequest&)> request_mesh_;
  std::uint64_t requests_ = 0;
  /// A publisher may invent names without end: those that nobody uses are forgotten now and then.
  std::map<std::string, Mesh> meshes_;  ///< by URI
  std::size_t max_meshes_ = kManyMeshes;
  RefusalLog marker_log_{"the marker", "further markers"};
  RefusalLog mesh_log_{"the mesh", "meshes of further objects"};
};

}  // namespace link_bounds
