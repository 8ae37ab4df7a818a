// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// One writer per format.
#include "mesh_seeds.h"

#include <sstream>

#include "testing/mesh_texts.h"

namespace link_bounds {
namespace {

using Index = std::uint32_t;

TriangleMesh octahedron() {
  return {
      {{1.5f, 0, 0}, {-1, 0.25f, 0}, {0, 2, 0.5f}, {0.5f, -1.25f, 0}, {0, 0, 3}, {0, 1, -0.75f}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

Corners cornersOf(const TriangleMesh& mesh) {
  Corners corners;
  for (const auto& triangle : mesh.triangles) {
    for (const Index index : triangle)
      corners.push_back(mesh.vertices[index]);
  }
  return corners;
}

/// "1.5 0 0" and a line end for each.
std::string vertexLines(const TriangleMesh& mesh, const std::string& prefix = "") {
  std::ostringstream lines;
  for (const Eigen::Vector3f& v : mesh.vertices)
    lines << prefix << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  return lines.str();
}

std::string triangleLines(const TriangleMesh& mesh, const std::string& prefix, Index first) {
  std::ostringstream lines;
  for (const auto& t : mesh.triangles)
    lines << prefix << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
  return lines.str();
}

std::string obj(const TriangleMesh& mesh) {
  return "o octahedron\n" + vertexLines(mesh, "v ") + triangleLines(mesh, "f ", 1);
}

std::string plyHeader(const TriangleMesh& mesh, const std::string& encoding) {
  return "ply\nformat " + encoding + " 1.0\nelement vertex " +
         std::to_string(mesh.vertices.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string asciiPly(const TriangleMesh& mesh) {
  return plyHeader(mesh, "ascii") + vertexLines(mesh) + triangleLines(mesh, "3 ", 0);
}

std::string vertexBytes(const TriangleMesh& mesh) {
  std::string bytes;
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    bytes += bytesOf(vertex.x()) + bytesOf(vertex.y()) + bytesOf(vertex.z());
  return bytes;
}

std::string triangleBytes(const TriangleMesh& mesh, const std::string& prefix) {
  std::string bytes;
  for (const auto& triangle : mesh.triangles)
    bytes += prefix + bytesOf(triangle);
  return bytes;
}

std::string binaryPly(const TriangleMesh& mesh) {
  return plyHeader(mesh, "binary_little_endian") + vertexBytes(mesh) + triangleBytes(mesh, "\3");
}

std::string daeGeometry(const std::string& id, const TriangleMesh& mesh,
                        const std::string& primitives) {
  const std::string count = std::to_string(mesh.vertices.size());
  return "<geometry id='" + id + "'><mesh><source id='" + id + "p'><float_array id='" + id +
         "a' count='" + std::to_string(3 * mesh.vertices.size()) + "'>" + vertexLines(mesh) +
         "</float_array><technique_common><accessor source='#" + id + "a' count='" + count +
         "' stride='3'><param name='X' type='float'/><param name='Y' type='float'/>"
         "<param name='Z' type='float'/></accessor></technique_common></source><vertices id='" +
         id + "v'><input semantic='POSITION' source='#" + id + "p'/></vertices>" + primitives +
         "</mesh></geometry>\n";
}

std::string dae(const TriangleMesh& mesh) {
  const std::string input = "<input semantic='VERTEX' source='#";
  const std::string indices = "<p>" + triangleLines(mesh, "", 0) + "</p>";
  return "<?xml version='1.0'?>\n"
         "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>\n"
         "<asset><unit meter='0.0254'/><up_axis>Z_UP</up_axis></asset>\n<library_geometries>\n" +
         daeGeometry(
             "g", mesh,
             "<triangles count='8'>" + input + "gv' offset='0'/>" + indices + "</triangles>") +
         daeGeometry("h", mesh,
                     "<polylist count='8'>" + input +
                         "hv' offset='0'/><vcount>3 3 3 3 3 3 3 3"
                         "</vcount>" +
                         indices + "</polylist>") +
         "</library_geometries>\n<library_visual_scenes><visual_scene id='s'>\n"
         "<node><translate>1.5 2.5 3.5</translate><rotate>0 0 1.0 30.0</rotate><scale>1.5 2.5 "
         "0.5</scale>"
         "<instance_geometry url='#g'/>\n<node><matrix>1 0 0 -4.5 0 0.8 0.6 0 0 -0.6 0.8 9.5 0 0 0 "
         "1"
         "</matrix><instance_geometry url='#h'/></node></node>\n"
         "</visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url='#s'/></scene></COLLADA>\n";
}

std::string glbOf(const TriangleMesh& mesh) {
  const std::string vertices = vertexBytes(mesh);
  const std::string triangles = triangleBytes(mesh, "");
  const std::string total = std::to_string(vertices.size() + triangles.size());
  return glb(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
             R"("nodes":[{"mesh":0,"translation":[1.5,2.5,3.5]}],)"
             R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
             R"("accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3",)"
             R"("min":[-1.25,-1.5,-0.5],"max":[1.5,2.25,3.5]},)"
             R"({"bufferView":1,"componentType":5125,"count":24,"type":"SCALAR"}],)"
             R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" +
                 std::to_string(vertices.size()) + R"(},{"buffer":0,"byteOffset":)" +
                 std::to_string(vertices.size()) + R"(,"byteLength":)" +
                 std::to_string(triangles.size()) + R"(}],"buffers":[{"byteLength":)" + total +
                 "}]}",
             vertices + triangles);
}

constexpr std::size_t kGlbHeader = 12;
constexpr std::size_t kChunkHeader = 8;

Index wordAt(const std::string& bytes, std::size_t offset) {
  Index word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

std::string chunk(const std::string& type, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  return bytesOf(static_cast<Index>(content.size())) + type + content;
}

}  // namespace

std::string glb(std::string json, std::string binary) {
  const std::string chunks =
      chunk("JSON", std::move(json), ' ') + chunk(std::string("BIN\0", 4), std::move(binary), '\0');
  return "glTF" + bytesOf(Index(2)) + bytesOf(static_cast<Index>(kGlbHeader + chunks.size())) +
         chunks;
}

std::string jsonOf(const std::string& glb) {
  return glb.substr(kGlbHeader + kChunkHeader, wordAt(glb, kGlbHeader));
}

std::string binaryOf(const std::string& glb) {
  return glb.substr(kGlbHeader + 2 * kChunkHeader + wordAt(glb, kGlbHeader));
}

std::vector<MeshSeed> meshSeeds() {
  const TriangleMesh mesh = octahedron();
  return {{"STL, text", ".stl", asciiStl(cornersOf(mesh)), true},
          {"STL, binary", ".stl", binaryStl(cornersOf(mesh)), false},
          {"DAE", ".dae", dae(mesh), true},
          {"OBJ", ".obj", obj(mesh), true},
          {"PLY, text", ".ply", asciiPly(mesh), true},
          {"PLY, binary", ".ply", binaryPly(mesh), false},
          {"GLB", ".glb", glbOf(mesh), false}};
}

}  // namespace link_bounds
