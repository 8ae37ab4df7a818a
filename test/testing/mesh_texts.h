// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Small mesh files as text, and what a test wants to know of an imported mesh.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"
#include "link_bounds/geometry/mesh/triangle_mesh.h"

namespace link_bounds {

/// The bytes of a value on a little-endian machine.
template <class Value>
std::string bytesOf(const Value& value) {
  std::string result(sizeof(Value), '\0');
  std::memcpy(result.data(), &value, sizeof(Value));
  return result;
}

using Corners = std::vector<Eigen::Vector3f>;

/// The four faces of a tetrahedron with legs of 1, 2 and 3, corner by corner.
inline Corners tetrahedronCorners() {
  const Eigen::Vector3f o(0, 0, 0);
  const Eigen::Vector3f x(1, 0, 0);
  const Eigen::Vector3f y(0, 2, 0);
  const Eigen::Vector3f z(0, 0, 3);
  return {o, y, x, o, x, z, o, z, y, x, y, z};
}

/// Three corners make a triangle.
inline std::string binaryStl(const Corners& corners, std::string header = "") {
  header.resize(80, ' ');
  std::string result = header + bytesOf(static_cast<std::uint32_t>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) result += std::string(12, '\0');  // normal
    for (int k = 0; k < 3; ++k)
      result += bytesOf(corners[i][k]);
    if (i % 3 == 2) result += std::string(2, '\0');  // attributes
  }
  return result;
}

/// A glTF whose three vertices are in another file.
inline std::string gltf(const std::string& buffer_uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
         R"("min":[0,0,0],"max":[1,2,3]}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
         R"("buffers":[{"byteLength":36,"uri":")" +
         buffer_uri + R"("}]})";
}

inline std::string asciiStl(const Corners& corners) {
  std::string result = "solid test\n";
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) result += "facet normal 0 0 0\nouter loop\n";
    result += "vertex";
    for (int k = 0; k < 3; ++k)
      result += " " + std::to_string(corners[i][k]);
    result += "\n";
    if (i % 3 == 2) result += "endloop\nendfacet\n";
  }
  return result + "endsolid test\n";
}

inline Aabb boundsOf(const TriangleMesh& mesh) {
  Aabb box;
  for (const Eigen::Vector3f& vertex : mesh.vertices)
    box.extend(vertex.cast<double>());
  return box;
}

}  // namespace link_bounds
