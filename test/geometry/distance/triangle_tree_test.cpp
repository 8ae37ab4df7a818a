// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each box holds its triangles, each triangle is in one leaf, and meshes of any kind cost little.
#include "geometry/distance/triangle_tree.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "geometry/distance/hull_vertices.h"
#include "geometry/distance/placed_box.h"
#include "testing/distance_bodies.h"
#include "testing/numbers.h"
#include "testing/part_meshes.h"
#include "testing/sanitized.h"

namespace link_bounds {
namespace {

using brute_force::Random;
using distance_oracle::Long;

std::vector<std::uint32_t> trianglesBelow(const TriangleTree& tree, std::uint32_t node) {
  const TreeNode& top = tree.nodes[node];
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; top.isLeaf() && i < top.count; ++i)
    result.push_back(top.first + i);
  for (std::uint32_t child = top.child; !top.isLeaf() && child < top.child + 2; ++child) {
    const auto below = trianglesBelow(tree, child);
    result.insert(result.end(), below.begin(), below.end());
  }
  EXPECT_EQ(result.size(), top.count);
  EXPECT_EQ(result.front(), top.first);
  EXPECT_EQ(result.back(), top.first + top.count - 1);
  return result;
}

/// A box is no narrower where floats place it, also by axes that scale and shear.
void expectContainedWhenPlaced(const TriangleTree& tree, std::uint32_t node, Random& random) {
  const Placement at{random.affine(0).linear(), random.vector(1)};
  const BoxPlacement boxes(at);
  const PlacedBox placed(tree.nodes[node], boxes);
  const Parallelepiped box = tree.nodes[node].box();
  double size = 0;
  for (const Eigen::Vector3d& edge : box.edges)
    size += at.linear.norm() * edge.norm();
  for (int i = 0; i < 20; ++i) {
    const distance_oracle::Vector direction = random.vector(1).normalized().cast<Long>();
    Long extent = 0;
    for (const Eigen::Vector3d& edge : box.edges)
      extent += std::abs(direction.dot(at.linear.cast<Long>() * edge.cast<Long>()));
    ASSERT_LE(extent, placed.extent(direction.cast<double>()));
    ASSERT_GE(extent, placed.extent(direction.cast<double>()) - 1e-5 * size);
  }
}

/// Along many directions, no triangle extends farther than the box, in long double.
void expectContained(const TriangleTree& tree, std::uint32_t node, Random& random) {
  const Parallelepiped box = tree.nodes[node].box();
  const auto triangles = trianglesBelow(tree, node);
  for (int i = 0; i < 20; ++i) {
    Eigen::Vector3d direction = random.vector(1).normalized();
    if (i < 6) {  // across a face
      const auto k = static_cast<std::size_t>(i % 3);
      direction = box.edges[(k + 1) % 3].stableNormalized().cross(
          box.edges[(k + 2) % 3].stableNormalized());
      if (i >= 3) direction = -direction;
    }
    const distance_oracle::Vector d = direction.cast<Long>();
    Long limit = d.dot(box.center.cast<Long>());
    for (const Eigen::Vector3d& edge : box.edges)
      limit += std::abs(d.dot(edge.cast<Long>()));
    const Long solid = d.dot(farthestOf(tree.solid, tree.size, direction).cast<Long>());
    const Long computed = tree.nodes[node].farthest(direction) + 1e-15 * tree.magnitude;
    for (const std::uint32_t triangle : triangles) {
      for (const Eigen::Vector3d& corner : tree.corners(triangle)) {
        ASSERT_LE(d.dot(corner.cast<Long>()) + solid, limit);
        ASSERT_LE(d.dot(corner.cast<Long>()) + solid, computed);
      }
    }
  }
}

/// Along many directions, no vertex is farther than the hull by more than its pad, and the hull's
/// points are vertices of the node.
void expectInHull(const TriangleTree& tree, std::uint32_t node, Random& random) {
  const NodeHull hull{tree, tree.nodes[node]};
  const auto triangles = trianglesBelow(tree, node);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d direction = random.vector(1).normalized();
    const Eigen::Vector3d solid = farthestOf(tree.solid, tree.size, direction);
    const Eigen::Vector3d point = hull.farthest(direction);
    const distance_oracle::Vector d = direction.cast<Long>();
    bool is_vertex = false;
    for (const std::uint32_t triangle : triangles) {
      for (const Eigen::Vector3d& corner : tree.corners(triangle)) {
        ASSERT_LE(d.dot((corner + solid - point).cast<Long>()), kHullPad * tree.magnitude);
        is_vertex = is_vertex || corner + solid == point;
      }
    }
    ASSERT_TRUE(is_vertex);
  }
}

void expectTree(const TriangleTree& tree, std::size_t triangles, Random& random) {
  const auto all = trianglesBelow(tree, 0);
  ASSERT_EQ(all.size(), triangles);
  ASSERT_EQ(std::set<std::uint32_t>(all.begin(), all.end()).size(), triangles);
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    ASSERT_TRUE(!tree.nodes[i].isLeaf() || tree.nodes[i].count <= kTrianglesPerLeaf);
    expectContained(tree, i, random);
    expectContainedWhenPlaced(tree, i, random);
    if (tree.nodes[i].count <= kSmallNode) expectInHull(tree, i, random);
  }
}

TEST(TriangleTree, HoldsTrianglesOfAnyKind) {
  Random random(1);
  for (int i = 0; i < repetitions(300); ++i) {
    const TriangleMesh mesh = anyMesh(random, random.magnitude(-20, 20));
    expectTree(*triangleTree(mesh), mesh.triangles.size(), random);
  }
}

TEST(TriangleTree, TakesNoMoreMemoryThanTheMax) {
  Random random(3);
  for (int i = 0; i < repetitions(100); ++i) {
    const TriangleMesh mesh = anyMesh(random, 1);
    EXPECT_LE(bytes(*triangleTree(mesh)), maxTreeBytes(mesh));
  }
  TriangleMesh unbalanced;  // the mean of the positions separates one triangle at a time
  for (std::uint32_t i = 0; i < 16; ++i) {
    const float x = std::ldexp(1.0f, 4 * static_cast<int>(i));
    for (const Eigen::Vector3f& corner :
         {Eigen::Vector3f(x, 0, 0), Eigen::Vector3f(x, x / 8, 0), Eigen::Vector3f(x, 0, x / 8)})
      unbalanced.vertices.push_back(corner);
    unbalanced.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto tree = triangleTree(unbalanced);
  EXPECT_EQ(tree->nodes.size(), 17u);
  EXPECT_LE(bytes(*tree), maxTreeBytes(unbalanced));
  EXPECT_LT(bytes(*triangleTree(ball(40, 60))), maxTreeBytes(ball(40, 60)) / 2);
}

TEST(TriangleTree, HoldsTrianglesThatASolidSweeps) {
  Random random(2);
  for (const Solid solid : {Solid::kBox, Solid::kEllipsoid, Solid::kCylinder}) {
    for (int i = 0; i < repetitions(100); ++i) {
      const TriangleMesh mesh = anyMesh(random, 1);
      std::vector<Eigen::Vector3d> vertices;
      for (const Eigen::Vector3f& vertex : mesh.vertices)
        vertices.push_back(vertex.cast<double>() + 1e-9 * random.vector(1));
      const Eigen::Vector3d size = random.vector(1).cwiseAbs();
      expectTree(*triangleTree(vertices, mesh.triangles, solid, size), mesh.triangles.size(),
                 random);
    }
  }
}

TEST(TriangleTree, IsNullForWhatCannotBeUsed) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(triangleTree(TriangleMesh{}));
  EXPECT_FALSE(triangleTree(TriangleMesh{{{0, 0, 0}}, {}}));
  EXPECT_FALSE(triangleTree(TriangleMesh{{{0, 0, 0}}, {{0, 0, 1}}}));
  EXPECT_FALSE(triangleTree(TriangleMesh{{{0, infinity, 0}}, {{0, 0, 0}}}));
  EXPECT_FALSE(triangleTree(TriangleMesh{{{std::nanf(""), 0, 0}}, {{0, 0, 0}}}));
  EXPECT_FALSE(triangleTree(TriangleMesh{{{1e31f, 0, 0}}, {{0, 0, 0}}}));
  EXPECT_FALSE(triangleTree({Eigen::Vector3d::Zero()}, {{0, 0, 0}}, Solid::kBox,
                            Eigen::Vector3d(1, kInfinity, 1)));
  EXPECT_TRUE(triangleTree(TriangleMesh{{{0, 0, 0}}, {{0, 0, 0}}}));
}

TEST(TriangleTree, TakesLittleMemoryForMeshesThatAreHardToDivide) {
  Random random(3);
  constexpr std::uint32_t count = repetitions(100'000);
  TriangleMesh slivers, equal, line;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(random.uniform(0, 1e-6));
    slivers.vertices.emplace_back(x, 0.0f, 0.0f);
    slivers.triangles.push_back({i, (i + 1) % count, (i + 2) % count});
    equal.triangles.push_back({0, 0, 0});
    // Each half is a small part of the rest.
    line.vertices.emplace_back(static_cast<float>(std::pow(0.999, i)), 0.0f, 0.0f);
    line.triangles.push_back({i, i, i});
  }
  equal.vertices = {{1, 2, 3}};
  for (const TriangleMesh& mesh : {slivers, equal, line})
    EXPECT_LE(bytes(*triangleTree(mesh)), 130 * count);
}

TEST(TriangleTree, LeavesOutNoVertexThatIsOutside) {
  Random random(7);
  const auto tree = triangleTree(ball(60, 120));  // neighbours are nearly in one plane
  for (std::uint32_t i = 0; i < tree->nodes.size(); ++i) {
    if (tree->nodes[i].count <= kSmallNode) expectInHull(*tree, i, random);
  }
}

TEST(TriangleTree, EndsItsListsWhereHullsNeedEachVertex) {
  Random random(8);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3000; i += 3) {
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back(random.vector(1).normalized().cast<float>());
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  const auto tree = triangleTree(mesh);
  const std::size_t most = kListedBytes / sizeof(TriangleTree::Offset) * mesh.triangles.size();
  EXPECT_GT(tree->hull_lists.size(), most / 2);
  EXPECT_LE(tree->hull_lists.size(), most + 3 * kSmallNode + 1);
  expectTree(*tree, mesh.triangles.size(), random);
}

/// The number of vertices that each node lists that is proven.
std::vector<std::size_t> hullSizes(const TriangleTree& tree) {
  std::vector<std::size_t> result;
  for (const TreeNode& node : tree.nodes) {
    if (node.hull_list > 0 && node.count > kProvenNode)
      result.push_back(tree.hull_lists[node.hull_list]);
  }
  return result;
}

/// Each vertex once.
void expectAllListed(const TriangleTree& tree, const TreeNode& node) {
  std::vector<std::uint32_t> used, listed;
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
    used.insert(used.end(), tree.triangles[i].begin(), tree.triangles[i].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  tree.forEachHullVertex(
      node, [&](TriangleTree::Offset offset) { listed.push_back(node.first_vertex + offset); });
  EXPECT_EQ(listed, used);
}

TEST(TriangleTree, ListsOnlyTheVerticesThatHullsNeed) {
  TriangleMesh plane;
  constexpr std::uint32_t kSide = 40;
  for (std::uint32_t x = 0; x < kSide; ++x) {
    for (std::uint32_t y = 0; y < kSide; ++y) {
      plane.vertices.emplace_back(0.01f * static_cast<float>(x), 0.01f * static_cast<float>(y),
                                  0.0f);
      if (x == 0 || y == 0) continue;
      const std::uint32_t i = x * kSide + y;
      plane.triangles.push_back({i, i - 1, i - kSide});
      plane.triangles.push_back({i - kSide - 1, i - 1, i - kSide});
    }
  }
  const auto tree = triangleTree(plane);
  const auto flat = hullSizes(*tree);
  ASSERT_GT(flat.size(), 5u);
  // Borders between nodes are jagged.
  EXPECT_LE(*std::max_element(flat.begin(), flat.end()), 12u);
  const auto round = hullSizes(*triangleTree(ball(20, 40)));
  ASSERT_GT(round.size(), 1u);
  EXPECT_GT(*std::max_element(round.begin(), round.end()), 50u);
  std::size_t count = 0;
  for (const TreeNode& node : tree->nodes) {
    if (node.hull_list == 0 || node.count > kProvenNode) continue;
    expectAllListed(*tree, node);
    ++count;
  }
  EXPECT_GT(count, 100u);
}

TEST(BodyDistance, OfPosesThatCannotBeUsedIsNothing) {
  MeshBody body;
  body.add(boxMesh({1, 1, 1}));
  const Eigen::Affine3d still = Eigen::Affine3d::Identity();
  EXPECT_FALSE(bodyDistance(Body(), still, body.body, still));
  for (const double bad : {std::nan(""), kInfinity, -kInfinity, 1e200}) {
    for (int entry = 0; entry < 12; ++entry) {
      Eigen::Affine3d pose = still;
      pose(entry % 3, entry / 3) = bad;
      EXPECT_FALSE(bodyDistance(body.body, pose, body.body, still));
      EXPECT_FALSE(bodyDistance(body.body, still, body.body, pose));
    }
  }
}

TEST(BodyDistance, OfPosesOfAnySizeIsProven) {
  Random random(4);
  MeshBody body;
  body.add(boxMesh({1, 1, 1}));
  for (int i = 0; i < repetitions(5000); ++i) {
    const double size = random.magnitude(i % 2 ? -300 : -20, 25);
    Eigen::Affine3d pose = random.rigid(0), other = random.affine(0);
    pose.linear() *= size;
    other.linear() *= size;
    pose.translation() = size * random.vector(random.magnitude(-3, 3));
    other.translation() = size * random.vector(random.magnitude(-3, 3));
    const auto found = bodyDistance(body.body, pose, body.body, other);
    ASSERT_TRUE(found);
    const auto exact = distance_oracle::distance(body.placed(pose), body.placed(other));
    ASSERT_LE(found->lower, exact);
    ASSERT_GE(found->upper, exact);
  }
}

TEST(TriangleTree, AnInterruptEndsTheWork) {
  TriangleMesh mesh;
  Random random(21);
  mesh.vertices = random.points(kIsSanitized ? 10000 : 20000, 1);
  for (std::uint32_t i = 0; i + 2 < mesh.vertices.size(); ++i)
    mesh.triangles.push_back({i, i + 1, i + 2});
  std::size_t calls = 0;
  triangleTree(mesh, [&calls] { ++calls; });
  EXPECT_GT(calls, 10u);
  for (const std::size_t end : {std::size_t{1}, calls / 2, calls}) {
    std::size_t left = end;
    const auto interrupt = [&left] {
      if (--left == 0) throw std::runtime_error("enough");
    };
    EXPECT_THROW(triangleTree(mesh, interrupt), std::runtime_error);
  }
}

}  // namespace
}  // namespace link_bounds
