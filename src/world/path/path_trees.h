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

/// A cache by points. Not thread-safe.
class PathTrees {
 public:
  using IsOver = std::function<bool()>;

  /// As RobotLoader::loadTrees(); ends early once the function returns true.
  using Load =
      std::function<std::vector<LoadedTree>(const std::vector<std::string>& uris, const IsOver&)>;

  explicit PathTrees(Load load) : load_(std::move(load)) {}

  /// Loads what the bodies of the scene need, as far as there is time: a body whose triangles are
  /// not there counts as its convex hull.
  void prepare(const PastScene& scene, const IsOver& is_over);

  /// The body of a link, in its frame, or of an object, in its own, as of the last prepare().
  Body bodyOf(const BoundedLink& link) const;
  Body bodyOf(const ObjectContent& content) const;

  /// Why the first body that lacks its triangles does so; "" if none does.
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
