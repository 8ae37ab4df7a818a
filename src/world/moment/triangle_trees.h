// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangle trees for distances. Each is requested when it is first needed.
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
  std::weak_ptr<const PointSet> points;  ///< points of the mesh or list that the tree is of
  std::shared_ptr<const TriangleTree> triangles;
  std::string error;  ///< "" if there is a tree
};

/// Functions that request trees. Both return at once; the tree comes back through
/// TriangleTrees::add(). A waiting request must not keep the points or the list alive: once they
/// are replaced or gone, nobody needs the tree.
struct TreeRequests {
  std::function<void(const std::string& mesh_uri, const std::shared_ptr<const PointSet>&)> mesh;
  std::function<void(std::shared_ptr<const ObjectContent> list)> list;
};

/// A cache of trees by points. An entry does not keep its points alive, and is erased after them.
class TriangleTrees {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Tree = std::shared_ptr<const TriangleTree>;

  explicit TriangleTrees(TreeRequests requests) : requests_(std::move(requests)) {}

  /// The tree of the points of a mesh file. Requests it on first use; null until it is there.
  Tree ofMesh(const std::string& uri, const std::shared_ptr<const PointSet>& points);

  /// As ofMesh() for the points of a list. Its tree is requested once the list has not changed for
  /// a while, because a tree of a list that changes all the time would be useless.
  Tree ofList(const std::shared_ptr<const ObjectContent>& content, Time now);

  /// Requests the trees of lists that have not changed for a while. To be called now and then.
  void requestSettled(Time now);

  void add(const MadeTree& made);

  /// Changes with each add().
  std::uint64_t version() const { return version_; }

  /// Allows trees that failed to be requested again when they are needed.
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
