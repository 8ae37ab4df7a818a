// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Files are found by their place in the folder of test data; the rest is computed.
#include "core_meshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <random>

#include "mesh_import.h"

namespace link_bounds::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFewestVertices = 100;  ///< smaller meshes tell nothing about scans

Mesh makeMesh(const std::string& name, const std::string& kind, TriangleMesh mesh) {
  auto points = std::make_shared<const PointSet>(mesh.vertices);
  return {name, kind, std::move(mesh), std::move(points)};
}

bool isMesh(const fs::path& path) {
  const std::string extension = path.extension();
  return extension == ".dae" || extension == ".stl" || extension == ".ply" || extension == ".obj";
}

std::vector<fs::path> meshFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && isMesh(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void addFiles(const fs::path& root, const std::string& below, const std::string& kind,
              std::vector<Mesh>& meshes) {
  for (const fs::path& path : meshFiles(root / below)) {
    try {
      TriangleMesh mesh = importMesh({fs::canonical(path), fs::canonical(root)});
      if (mesh.vertices.size() < kFewestVertices) continue;
      meshes.push_back(makeMesh(fs::relative(path, root), kind, std::move(mesh)));
    } catch (const MeshError& error) {
      std::cerr << "left out " << path << ": " << error.what() << "\n";
    }
  }
}

/// A sheet of n * n squares over [-1, 1]^2, at height z.
TriangleMesh sheet(int n, double z) {
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j)
      mesh.vertices.push_back(Eigen::Vector3d(2.0 * i / n - 1, 2.0 * j / n - 1, z).cast<float>());
  }
  const auto index = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
      mesh.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

/// Both large faces of a plate, finely divided and turned about x.
TriangleMesh plate(double degrees) {
  TriangleMesh mesh = sheet(40, 0);
  const TriangleMesh other = sheet(40, 0.1);
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  const Eigen::AngleAxisd turn(degrees * M_PI / 180, Eigen::Vector3d::UnitX());
  for (Eigen::Vector3f& vertex : mesh.vertices)
    vertex = (turn * vertex.cast<double>()).cast<float>();
  return mesh;
}

/// Every vertex is extreme. The triangles only say that all are used.
TriangleMesh sphere(int count) {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d direction(normal(engine), normal(engine), normal(engine));
    mesh.vertices.push_back(direction.normalized().cast<float>());
  }
  for (std::uint32_t i = 0; i + 2 < static_cast<std::uint32_t>(count); ++i)
    mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

void keepAFew(std::vector<Mesh>& meshes) {
  std::vector<Mesh> few;
  for (const char* part : {"ur5e/visual/base.dae", "ur5e/visual/forearm.dae", "ur5e/visual/wrist1",
                           "visual/link0.dae", "visual/link5.dae", "visual/hand.dae"}) {
    const auto found = std::find_if(meshes.begin(), meshes.end(), [part](const Mesh& mesh) {
      return mesh.name.find(part) != std::string::npos;
    });
    if (found != meshes.end()) few.push_back(*found);
  }
  if (!few.empty()) meshes = std::move(few);
}

}  // namespace

std::vector<Mesh> loadMeshes(const std::string& data_folder, const std::string& demo_folder,
                             bool quick) {
  std::vector<Mesh> meshes;
  if (data_folder.empty()) {
    std::cerr << "LINK_BOUNDS_DATA is not set: only the demo robot's meshes and synthetic ones\n";
    addFiles(demo_folder, ".", "robot", meshes);
  } else {
    const fs::path robots = fs::path(data_folder) / "robots";
    for (const char* robot : {"franka_description/meshes/visual", "ur_description/meshes"})
      addFiles(robots, robot, "robot", meshes);
    if (quick) keepAFew(meshes);
    if (!quick) addFiles(robots, "pr2_description/meshes", "robot", meshes);
    addFiles(robots, "stanford_models/meshes", "model", meshes);
    meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                                [](const Mesh& mesh) {
                                  return mesh.name.find("formats") != std::string::npos;
                                }),
                 meshes.end());
  }
  meshes.push_back(makeMesh("plate", "synthetic", plate(0)));
  meshes.push_back(makeMesh("tilted_plate", "synthetic", plate(45)));
  meshes.push_back(makeMesh("sphere_10000", "synthetic", sphere(10000)));
  return meshes;
}

}  // namespace link_bounds::bench
