// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which vertices welding merges and drops, and which meshes it refuses.
#include "robot/mesh/weld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "link_bounds/geometry/mesh/triangle_mesh.h"
#include "testing/brute_force.h"
#include "testing/refusal.h"

namespace link_bounds {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Eigen::Vector3f kA(0, 0, 0);
const Eigen::Vector3f kB(1, 0, 0);
const Eigen::Vector3f kC(0, 1, 0);
const Eigen::Vector3f kD(0, 0, 1);

TEST(Welded, MergesBitEqualVertices) {
  const TriangleMesh mesh = welded({{kA, kB, kC, kB, kA, kD}, {{0, 1, 2}, {3, 4, 5}}});
  EXPECT_EQ(mesh.vertices, (std::vector<Eigen::Vector3f>{kA, kB, kC, kD}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 0, 3}}));
}

TEST(Welded, KeepsVerticesOneUlpApart) {
  const Eigen::Vector3f near_b(std::nextafter(1.0f, 2.0f), 0, 0);
  EXPECT_EQ(welded({{kA, kB, near_b}, {{0, 1, 2}}}).vertices.size(), 3u);
}

TEST(Welded, MinusZeroIsPlusZero) {
  const Eigen::Vector3f minus(-0.0f, -0.0f, -0.0f);
  const TriangleMesh mesh = welded({{minus, kA, kB}, {{0, 1, 2}}});
  ASSERT_EQ(mesh.vertices.size(), 2u);
  for (int k = 0; k < 3; ++k)
    EXPECT_FALSE(std::signbit(mesh.vertices[0][k]));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 0, 1}}));
}

TEST(Welded, DropsVerticesThatNoTriangleUses) {
  const Eigen::Vector3f far_away(1000, 1000, 1000);
  const TriangleMesh mesh = welded({{far_away, kA, kB, far_away, kC}, {{1, 2, 4}}});
  EXPECT_EQ(mesh.vertices, (std::vector<Eigen::Vector3f>{kA, kB, kC}));
}

TEST(Welded, OrdersVerticesByFirstUse) {
  const TriangleMesh mesh = welded({{kA, kB, kC, kD}, {{3, 1, 2}, {1, 0, 3}}});
  EXPECT_EQ(mesh.vertices, (std::vector<Eigen::Vector3f>{kD, kB, kC, kA}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 0}}));
}

TEST(Welded, KeepsDegenerateTriangles) {
  const TriangleMesh mesh = welded({{kA, kB}, {{0, 1, 1}, {0, 0, 0}}});
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 1}, {0, 0, 0}}));
}

TEST(Welded, AgreesWithAnOrderedMapOnManyDuplicates) {
  brute_force::Random random(1);
  TriangleMesh source;
  for (int i = 0; i < 20000; ++i) {
    source.vertices.push_back(random.vector(12).array().round().cast<float>());
  }
  for (std::uint32_t i = 0; i + 2 < source.vertices.size(); ++i) {
    source.triangles.push_back({i, i + 1, i + 2});
  }
  const TriangleMesh mesh = welded(source);
  std::map<std::array<float, 3>, int> distinct;
  for (const auto& v : source.vertices)
    distinct[{v.x(), v.y(), v.z()}] = 0;
  EXPECT_EQ(mesh.vertices.size(), distinct.size());
  for (std::size_t i = 0; i < source.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      ASSERT_EQ(mesh.vertices[mesh.triangles[i][corner]],
                source.vertices[source.triangles[i][corner]]);
    }
  }
}

TEST(Welded, RefusesAnIndexOfNoVertex) {
  EXPECT_THROW(welded({{kA, kB, kC}, {{0, 1, 3}}}), MeshError);
  EXPECT_THROW(welded({{kA, kB, kC}, {{0xFFFFFFFFu, 1, 2}}}), MeshError);
  EXPECT_THROW(welded({{}, {{0, 0, 0}}}), MeshError);
}

TEST(Welded, RefusesUsedVerticesThatAreNotFinite) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3f vertex = kB;
      vertex[k] = bad;
      EXPECT_THROW(welded({{kA, vertex, kC}, {{0, 1, 2}}}), MeshError) << bad << " in " << k;
    }
  }
}

TEST(Welded, UnusedVerticesMayBeAnything) {
  const Eigen::Vector3f bad(kNan, kInfinity, 0);
  EXPECT_EQ(welded({{bad, kA, kB, kC}, {{1, 2, 3}}}).vertices.size(), 3u);
}

TEST(Welded, RefusesAMeshWithoutTriangles) {
  EXPECT_THROW(welded({{kA, kB, kC}, {}}), MeshError);
  EXPECT_THROW(welded({}), MeshError);
}

TEST(Welded, TheErrorNamesTheIndexAndTheCount) {
  const std::string reason = refusalOf<MeshError>([] { welded({{kA, kB, kC}, {{0, 1, 17}}}); });
  EXPECT_NE(reason.find("17 of 3"), std::string::npos) << reason;
}

}  // namespace
}  // namespace link_bounds
