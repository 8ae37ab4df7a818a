// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Updates of few and many links: what memory costs when the tables do not fit the caches.
#include <algorithm>
#include <array>

#include "bench/core/judgement.h"
#include "bench/core/methods.h"
#include "geometry/support/table/direction_table.h"
#include "link_bounds/geometry/shape/link_boxes.h"
#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr std::array<std::size_t, 5> kLinkCounts{1, 10, 50, 200, 1000};
constexpr std::size_t kMostLinks = kLinkCounts.back();
constexpr std::size_t kSharedMeshes = 16;

/// Twice as many as the links of the largest update, so that every link turns in every update.
const Poses& linkPoses() {
  static const Poses poses = randomPoses(2 * kMostLinks);
  return poses;
}

/// A robot whose every link has a mesh, and moves in every update.
struct Links {
  LinkBoxes boxes;
  std::vector<MovedLink> moved;

  Links(const MeasuredMeshes& meshes, std::size_t count) {
    std::vector<BoundedLink> links(count);
    for (std::size_t i = 0; i < count; ++i) {
      links[i].shapes.push_back({meshes[i % meshes.size()].points});
      moved.push_back({i, nullptr});
    }
    boxes = LinkBoxes(links);
  }

  void update(const Eigen::Affine3d* poses) {
    for (MovedLink& link : moved)
      link.world_from_link = poses + link.link;
    boxes.update(moved);
  }
};

/// Meshes of robots with a table of their own each, in turn; a copy of the points that count is as
/// good as a further mesh.
MeasuredMeshes distinctMeshes(const MeasuredMeshes& meshes, std::size_t count) {
  MeasuredMeshes originals;
  std::copy_if(meshes.begin(), meshes.end(), std::back_inserter(originals),
               [](const MeasuredMesh& mesh) {
                 return mesh.kind == "robot" && mesh.points->size() > kScannedPoints;
               });
  MeasuredMeshes result;
  for (std::size_t i = 0; i < count && !originals.empty(); ++i) {
    const MeasuredMesh& original = originals[i % originals.size()];
    result.push_back({original.name, original.kind, {}, nullptr});
    result.back().points = std::make_shared<const PointSet>(original.points->points());
  }
  return result;
}

/// The boxes of one update beside a loop over the points that can be extreme.
Judgement judge(const MeasuredMeshes& meshes, Links& links) {
  links.update(linkPoses().data());
  Boxes boxes, exact;
  for (std::size_t i = 0; i < links.moved.size(); ++i) {
    boxes.push_back(links.boxes.box(i).value());
    exact.push_back(brute_force::box(meshes[i % meshes.size()].points->points(), linkPoses()[i]));
  }
  return bench::judge(boxes, exact);
}

/// Sums over the meshes, each counted once.
Result totals(const std::string& name, const MeasuredMeshes& meshes, std::size_t count,
              const Judgement& judgement) {
  Result result{
      name, "synthetic", 0, 0, nameOfOurs(queryPath()), judgement.exact, judgement.volume_ratio, 0};
  for (std::size_t i = 0; i < std::min(count, meshes.size()); ++i) {
    result.hull += meshes[i].points->size();
    result.bytes += meshes[i].points->bytes();
  }
  return result;
}

void addCount(const std::string& name, const MeasuredMeshes& meshes, std::size_t count,
              Suite& suite) {
  const QueryPath path = queryPath();
  const auto links = std::make_shared<Links>(meshes, count);
  const auto body = [path, count, links](benchmark::State& state) {
    useQueryPath(path);
    std::size_t first = 0;
    for (auto _ : state) {
      links->update(&linkPoses()[first]);
      benchmark::ClobberMemory();
      first = first + 2 * count <= linkPoses().size() ? first + count : 0;
    }
  };
  suite.push_back({totals(name, meshes, count, judge(meshes, *links)), body, count});
}

}  // namespace

void addLinkCounts(const MeasuredMeshes& meshes, Suite& suite) {
  const MeasuredMeshes distinct = distinctMeshes(meshes, kMostLinks);
  if (distinct.empty()) return;
  const MeasuredMeshes shared(distinct.begin(), distinct.begin() + kSharedMeshes);
  for (const std::size_t count : kLinkCounts) {
    const std::string name = "links:" + std::to_string(count) + ":";
    addCount(name + "shared16", shared, count, suite);
    addCount(name + "distinct", distinct, count, suite);
  }
}

}  // namespace link_bounds::bench
