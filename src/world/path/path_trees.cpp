// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads a few files at a time. If the time of a request is over, the next request continues from
// there.
#include "world/path/path_trees.h"

#include <iterator>

#include "world/moment/object_body.h"

namespace link_bounds {
namespace {

constexpr std::size_t kFilesAtOnce = 8;
constexpr const char* kNotLoaded = "its triangles were not loaded in time; ask again";

/// Thrown to abort the making of a tree.
struct Over {};

}  // namespace

void PathTrees::prepare(const PastScene& scene, const IsOver& is_over) {
  problem_.clear();
  for (auto entry = trees_.begin(); entry != trees_.end();)
    entry = entry->second.points.expired() ? trees_.erase(entry) : std::next(entry);
  Meshes meshes = scene.model->mesh_uris;
  for (const PastBody& body : scene.bodies) {
    if (!body.object || !body.frame || !hasTree(*body.object)) continue;
    const ObjectContent& content = *body.object;
    const auto& points = content.bounded.shapes.front().points;
    if (content.mesh_uri.empty())
      makeList(content, is_over);
    else if (points)
      meshes.emplace(content.mesh_uri, points);
  }
  for (auto mesh = meshes.begin(); mesh != meshes.end();)
    mesh = has(mesh->second) ? meshes.erase(mesh) : std::next(mesh);
  loadMeshes(meshes, is_over);
}

void PathTrees::loadMeshes(const Meshes& meshes, const IsOver& is_over) {
  std::vector<std::string> uris;
  std::vector<std::shared_ptr<const PointSet>> points;
  const auto load = [&] {
    const std::vector<LoadedTree> trees = load_(uris, is_over);
    for (std::size_t i = 0; i < trees.size(); ++i) {
      const bool is_same = trees[i].points == points[i];
      if (is_same && trees[i].triangles)
        add(points[i], trees[i].triangles);
      else if (trees[i].is_cancelled)
        complain(uris[i] + ": " + kNotLoaded);
      else
        complain(!trees[i].error.empty() ? trees[i].error
                                         : uris[i] + " was replaced since it was loaded");
    }
    uris.clear();
    points.clear();
  };
  for (const auto& [uri, of_mesh] : meshes) {
    if (is_over()) return complain(uri + ": " + kNotLoaded);
    uris.push_back(uri);
    points.push_back(of_mesh);
    if (uris.size() == kFilesAtOnce) load();
  }
  if (!uris.empty()) load();
}

void PathTrees::makeList(const ObjectContent& content, const IsOver& is_over) {
  const auto& points = content.bounded.shapes.front().points;
  if (!points || has(points)) return;
  try {
    const MadeTree made = listTree(content, [&] {
      if (is_over()) throw Over();
    });
    if (made.triangles)
      add(points, made.triangles);
    else
      complain(made.error);
  } catch (const Over&) {
    complain(content.bounded.name + ": " + kNotLoaded);
  }
}

void PathTrees::complain(const std::string& problem) {
  if (problem_.empty()) problem_ = problem;
}

bool PathTrees::has(const std::shared_ptr<const PointSet>& points) const {
  return treeOf(points) != nullptr;
}

void PathTrees::add(const std::shared_ptr<const PointSet>& points,
                    std::shared_ptr<const TriangleTree> tree) {
  trees_[points.get()] = {points, std::move(tree)};
}

/// Compares the points, too: freed points may have had the same address.
std::shared_ptr<const TriangleTree> PathTrees::treeOf(
    const std::shared_ptr<const PointSet>& points) const {
  const auto found = trees_.find(points.get());
  if (found == trees_.end() || found->second.points.lock() != points) return nullptr;
  return found->second.triangles;
}

Body PathTrees::bodyOf(const BoundedLink& link) const {
  Body body;
  for (const Shape& shape : link.shapes)
    body.shapes.push_back({shape, shape.points ? treeOf(shape.points) : nullptr});
  return body;
}

Body PathTrees::bodyOf(const ObjectContent& content) const {
  const bool has_tree = hasTree(content) && content.bounded.shapes.front().points;
  return objectBody(content, has_tree ? treeOf(content.bounded.shapes.front().points) : nullptr);
}

}  // namespace link_bounds
