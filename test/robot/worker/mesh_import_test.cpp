// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The same tetrahedron from every format, and what else files hold. For Collada see
// mesh_import_dae_test.
#include "robot/worker/mesh_import.h"

#include <gtest/gtest.h>

#include "testing/mesh_texts.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

TriangleMesh import(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  return importMesh({folder.write(name, content), folder.path().string()});
}

void expectBounds(const TriangleMesh& mesh, const Eigen::Vector3d& min,
                  const Eigen::Vector3d& max) {
  EXPECT_EQ(boundsOf(mesh).min(), min);
  EXPECT_EQ(boundsOf(mesh).max(), max);
}

void expectTetrahedron(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  expectBounds(mesh, {0, 0, 0}, {1, 2, 3});
}

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
    "property float z\nelement face ";
const std::string kPlyBody =
    "\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 2 0\n0 0 3\n9 9 9\n";

TEST(ImportStl, Binary) {
  expectTetrahedron(import("a.stl", binaryStl(tetrahedronCorners())));
}

TEST(ImportStl, Ascii) {
  expectTetrahedron(import("a.stl", asciiStl(tetrahedronCorners())));
}

TEST(ImportStl, BinaryThatBeginsLikeAscii) {
  expectTetrahedron(import("a.stl", binaryStl(tetrahedronCorners(), "solid part of a robot")));
}

TEST(ImportStl, ExtensionInUpperCase) {
  expectTetrahedron(import("A.STL", binaryStl(tetrahedronCorners())));
  expectTetrahedron(import("A.StL", asciiStl(tetrahedronCorners())));
}

TEST(ImportStl, CoordinatesAreKeptToTheBit) {
  const Corners corners{{0.1f, -1e-30f, 3e37f}, {1.0f / 3, 16777217.0f, -0.7f}, {1e-42f, 2, 3}};
  EXPECT_EQ(import("a.stl", binaryStl(corners)).vertices, corners);
}

TEST(ImportStl, DegenerateTrianglesCount) {
  const Corners corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}};
  expectBounds(import("a.stl", binaryStl(corners)), {0, 0, 0}, {5, 5, 5});
}

/// As in rviz.
TEST(ImportGltf, MorphTargetsDoNotMoveVertices) {
  const TemporaryFolder folder;
  std::string text = gltf("a.bin");
  const auto replace = [&](const std::string& old, const std::string& now) {
    text.replace(text.find(old), old.size(), now);
  };
  replace(R"("attributes":{"POSITION":0}})",
          R"("attributes":{"POSITION":0},"targets":[{"POSITION":0}]})");
  replace(R"("meshes":[{)", R"("meshes":[{"weights":[1],)");
  std::string numbers;
  for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 3.f})
    numbers += bytesOf(number);
  folder.write("a.bin", numbers);
  const TriangleMesh mesh = importMesh({folder.write("a.gltf", text), folder.path().string()});
  EXPECT_EQ(boundsOf(mesh).max(), Eigen::Vector3d(1, 2, 3));
}

TEST(ImportObj, VerticesThatNoFaceUsesAreDropped) {
  expectTetrahedron(import("a.obj",
                           "v 0 0 0\nv 1 0 0\nv 9 9 9\nv 0 2 0\nv 0 0 3\n"
                           "f 1 4 2\nf 1 2 5\nf 1 5 4\nf 2 4 5\n"));
}

TEST(ImportObj, LinesAndPointsAreIgnored) {
  expectTetrahedron(import("a.obj",
                           "v 0 0 0\nv 1 0 0\nv 9 9 9\nv 0 2 0\nv 0 0 3\nv -9 0 0\n"
                           "f 1 4 2\nf 1 2 5\nl 1 3\nf 1 5 4\nf 2 4 5\np 6\n"));
}

TEST(ImportObj, QuadsAndLargerPolygonsAreTriangulated) {
  const TriangleMesh quad = import("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(quad.triangles.size(), 2u);
  expectBounds(quad, {0, 0, 0}, {1, 1, 0});
  const TriangleMesh hexagon =
      import("a.obj", "v 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\nf 1 2 3 4 5 6\n");
  EXPECT_EQ(hexagon.triangles.size(), 4u);
  expectBounds(hexagon, {-2, -2, 0}, {2, 2, 0});
}

TEST(ImportObj, ANotchOfAPolygonIsEmpty) {
  const TriangleMesh mesh =
      import("a.obj", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");  // an arrow
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f edge = mesh.vertices[b] - mesh.vertices[a];
    area += edge.cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
  }
  EXPECT_EQ(area, 1);
}

TEST(ImportObj, SeveralObjectsAreOneMesh) {
  const TriangleMesh mesh = import("a.obj",
                                   "o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                                   "o second\nv 5 5 5\nv 6 5 5\nv 5 6 5\nf 4 5 6\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  expectBounds(mesh, {0, 0, 0}, {6, 6, 5});
}

TEST(ImportObj, AMissingMaterialDoesNotMatter) {
  const TriangleMesh mesh =
      import("a.obj", "mtllib none.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(ImportPly, FacesOfSeveralSizes) {
  const TriangleMesh mesh =
      import("a.ply", kPlyHeader + "3" + kPlyBody + "3 0 2 1\n3 0 1 3\n4 0 3 2 1\n");
  EXPECT_EQ(mesh.triangles.size(), 4u);
  expectBounds(mesh, {0, 0, 0}, {1, 2, 3});
}

TEST(ImportOff, Faces) {
  expectTetrahedron(import("a.off",
                           "OFF\n4 4 0\n0 0 0\n1 0 0\n0 2 0\n0 0 3\n"
                           "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"));
}

/// The tetrahedron as binary glTF whose node is moved by (10, 0, 0).
std::string glb() {
  std::string buffer;
  for (const Eigen::Vector3f& vertex : {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 0, 0),
                                        Eigen::Vector3f(0, 2, 0), Eigen::Vector3f(0, 0, 3)}) {
    for (int k = 0; k < 3; ++k)
      buffer += bytesOf(vertex[k]);
  }
  const std::uint16_t indices[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  for (const std::uint16_t index : indices)
    buffer += bytesOf(index);
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"mesh":0,"translation":[10,0,0]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
      R"("min":[0,0,0],"max":[1,2,3]},)"
      R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},)"
      R"({"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{"byteLength":72}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto length = [](std::size_t size) { return bytesOf(static_cast<std::uint32_t>(size)); };
  return "glTF" + length(2) + length(12 + 8 + json.size() + 8 + buffer.size()) +
         length(json.size()) + "JSON" + json + length(buffer.size()) + std::string("BIN\0", 4) +
         buffer;
}

TEST(ImportGltf, BinaryWithANodeTransform) {
  const TriangleMesh mesh = import("a.glb", glb());
  EXPECT_EQ(mesh.triangles.size(), 4u);
  expectBounds(mesh, {10, 0, 0}, {11, 2, 3});
}

}  // namespace
}  // namespace link_bounds
