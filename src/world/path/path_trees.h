// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of the bodies of ~check_path, loaded by the thread that needs them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "link_bounds/robot/robot_loader.h"
#include "world/history/past_scene.h"
#include "world/model/model.h"

namespace link_bounds {

/// A cache of triangle trees by mesh points. Not thread-safe.
class PathTrees {
 public:
  using IsOver = std::function<bool()>;

  /// Loads as RobotLoader::loadTrees() does, and ends early once IsOver returns true.
  using Load =
      std::function<std::vector<LoadedTree>(const std::vector<std::string>& uris, const IsOver&)>;

  explicit PathTrees(Load load) : load_(std::move(load)) {}

  /// Loads the triangles of the bodies of the scene until `is_over` returns true. A body without
  /// loaded triangles counts as its convex hull.
  void prepare(const PastScene& scene, const IsOver& is_over);

  /// The body of a link or of an object, in its own frame, with the triangles that are loaded.
  Body bodyOf(const BoundedLink& link) const;
  Body bodyOf(const ObjectContent& content) const;

  /// Why the triangles of the first body without them are missing; "" if none are missing.
  const std::string& problem() const { return problem_; }

  void forget() { trees_.clear(); }

 private:
  struct Entry {
    std::weak_ptr<const PointSet> points;
    std::shared_ptr<const TriangleTree> triangles;
  };
  using Meshes = std::map<std::string, std::shared_ptr<const PointSet>>;

  bool has(const std::shared_ptr<const PointSet>& points) const;
  void add(const std::shared_ptr<const PointSet>& points, std::shared_ptr<const TriangleTree> tree);
  std::shared_ptr<const TriangleTree> treeOf(const std::shared_ptr<const PointSet>& points) const;
  void loadMeshes(const Meshes& meshes, const IsOver& is_over);
  void makeList(const ObjectContent& content, const IsOver& is_over);
  void complain(const std::string& problem);

  Load load_;
  std::map<const PointSet*, Entry> trees_;
  std::string problem_;
};

}  // namespace link_bounds
