// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The trees of triangles that distances need: requested when they are first needed.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "link_bounds/geometry/distance/body.h"
#include "world/bodies/live_object.h"

namespace link_bounds {

/// A tree, or why there is none.
struct MadeTree {
  std::weak_ptr<const PointSet> points;  ///< to which it belongs
  std::shared_ptr<const TriangleTree> triangles;
  std::string error;  ///< "" if there is a tree
};

/// How trees are requested. Both return at once; the tree comes back through TriangleTrees::add().
/// A request must not keep points or a list alive while it waits: once they are replaced or gone,
/// nobody waits for the tree.
struct TreeRequests {
  std::function<void(const std::string& mesh_uri, const std::shared_ptr<const PointSet>&)> mesh;
  std::function<void(std::shared_ptr<const ObjectContent> list)> list;
};

/// A cache by points. An entry dies with its points, which it does not keep alive.
class TriangleTrees {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Tree = std::shared_ptr<const TriangleTree>;

  explicit TriangleTrees(TreeRequests requests) : requests_(std::move(requests)) {}

  /// The tree of these points, which are those of a mesh file. Null if there is none yet.
  Tree ofMesh(const std::string& uri, const std::shared_ptr<const PointSet>& points);

  /// The same for the points of a list, which is requested when it has not changed for a while: a
  /// list that deforms all the time would only cost time.
  Tree ofList(const std::shared_ptr<const ObjectContent>& content, Time now);

  /// To be called now and then: requests the trees of lists that have not changed for a while.
  void requestSettled(Time now);

  void add(const MadeTree& made);

  /// Changes with each add().
  std::uint64_t version() const { return version_; }

  /// What had no tree is requested again when it is needed.
  void forgetErrors();

  /// Erases the entries of points that are gone.
  void forgetUnused();

  /// Why meshes and lists have no tree, one entry each.
  std::vector<std::string> errors() const;

 private:
  struct Entry {
    std::weak_ptr<const PointSet> points;
    std::weak_ptr<const ObjectContent> list;  ///< null for a mesh
    Time since;                               ///< when the list was first seen
    bool is_settling = false;                 ///< its tree has not been requested
    Tree triangles;
    std::string error;
  };

  std::pair<Entry&, bool> entryOf(const std::shared_ptr<const PointSet>& points);

  TreeRequests requests_;
  std::map<const PointSet*, Entry> entries_;
  std::uint64_t version_ = 0;
};

}  // namespace link_bounds
