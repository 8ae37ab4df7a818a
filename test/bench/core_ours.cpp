// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The library's own boxes, by each path of instructions, with outward rounding.
#include <algorithm>

#include "core_suite.h"
#include "link_bounds/link_boxes.h"

namespace link_bounds::bench {
namespace {

struct Ours {
  QueryPath path;
  Shape shape;
  ShapeReach reach;

  Ours(QueryPath query_path, const Mesh& mesh)
      : path(query_path), shape{mesh.points}, reach(shape) {}

  void start() const { useQueryPath(path); }
  Eigen::Affine3d prepare(const Eigen::Affine3d& pose) const { return pose; }
  std::optional<Aabb> box(const Eigen::Affine3d& pose) { return placedBox(shape, pose, reach); }
  Aabb toAabb(const std::optional<Aabb>& box) const { return box.value(); }
  std::size_t bytes() const { return shape.points->bytes(); }
};

/// As many links as asked for, each with a pose of its own, all updated in one go.
struct Links {
  std::vector<BoundedLink> links;
  std::vector<LinkReach> reaches;
  std::vector<Eigen::Affine3d> poses;
  std::size_t turn = 0;

  void updateAll() {
    ++turn;
    for (std::size_t i = 0; i < links.size(); ++i) {
      auto box = linkBox(links[i], poses[(i + turn) % poses.size()], reaches[i]);
      benchmark::DoNotOptimize(box);
    }
  }
};

Links makeLinks(const std::vector<Mesh>& meshes, std::size_t count, bool shared) {
  Links result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& points = meshes[i % std::min<std::size_t>(16, meshes.size())].points;
    Shape shape;
    shape.points = shared ? points : std::make_shared<const PointSet>(*points);
    result.links.push_back({"link", {shape}, 0, ""});
    result.reaches.emplace_back(result.links.back());
  }
  result.poses = makeTask(meshes[0]).poses;
  return result;
}

}  // namespace

void addOurs(const Task& turning, const Task& moving) {
  const QueryPath best = queryPath();
  addCase("ours_plain", turning, Ours(QueryPath::kPlain, turning.mesh));
  if (isSupported(QueryPath::kSse2))
    addCase("ours_sse2", turning, Ours(QueryPath::kSse2, turning.mesh));
  if (isSupported(QueryPath::kAvx2))
    addCase("ours_avx2", turning, Ours(QueryPath::kAvx2, turning.mesh));
  addCase("ours_unchanged", moving, Ours(best, moving.mesh));
  useQueryPath(best);
}

void addLinkCounts(const std::vector<Mesh>& meshes) {
  std::vector<Mesh> robot;
  for (const Mesh& mesh : meshes) {
    if (mesh.kind == "robot") robot.push_back(mesh);
  }
  for (const bool shared : {true, false}) {
    for (const std::size_t count : {1u, 10u, 50u, 200u, 1000u}) {
      auto links = std::make_shared<Links>(makeLinks(robot, count, shared));
      const std::string name =
          "links:" + std::to_string(count) + (shared ? ":shared16" : ":distinct");
      registerCase(
          {name, "synthetic", 0, 0, "ours", true, 1, 0, {}},
          [links, best = queryPath()](benchmark::State& state) {
            useQueryPath(best);
            for (auto _ : state)
              links->updateAll();
          },
          static_cast<int>(count));
    }
  }
}

}  // namespace link_bounds::bench
