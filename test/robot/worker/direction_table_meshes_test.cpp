// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Real meshes: extents equal those of the scan over all vertices, to the bit.
// LINK_BOUNDS_TEST_MAPS says how many linear maps are tried per mesh.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "robot/worker/mesh_import.h"
#include "testing/exactness.h"
#include "testing/linear_maps.h"
#include "testing/robot_files.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

constexpr int kMaps = 90;

int mapCount() {
  const char* text = std::getenv("LINK_BOUNDS_TEST_MAPS");
  return text ? std::stoi(text) : kMaps;
}

std::vector<fs::path> meshesBelow(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    std::string extension = entry.path().extension();
    for (char& letter : extension)
      letter = static_cast<char>(std::tolower(letter));
    for (const char* known : {".dae", ".stl", ".ply", ".obj", ".off", ".glb"}) {
      if (extension == known) found.push_back(entry.path());
    }
  }
  return found;
}

Exactness compareMesh(const std::vector<Eigen::Vector3f>& vertices) {
  const PointSet set(vertices);
  LinearMaps maps(vertices.size());
  Exactness result;
  for (int i = 0; i < mapCount(); ++i)
    result += compare(vertices, set, maps.next());
  EXPECT_LE(set.bytes(), std::max<std::size_t>(128 * 1024, 48 * set.size()) + sizeof(PointSet));
  return result;
}

void compareMeshesBelow(const fs::path& folder) {
  Exactness all;
  int meshes = 0;
  for (const fs::path& path : meshesBelow(folder)) {
    SCOPED_TRACE(path);
    try {
      const TriangleMesh mesh = importMesh({fs::canonical(path), fs::canonical(folder)});
      const Exactness found = compareMesh(mesh.vertices);
      EXPECT_EQ(found.wrong, 0) << found.wrong_map;
      all += found;
      ++meshes;
    } catch (const MeshError& error) {
      std::cout << "left out: " << path.filename() << ": " << error.what() << "\n";
    }
  }
  EXPECT_GT(meshes, 0);
  EXPECT_LE(all.ties, all.compared / 10000);
  std::cout << "exact: " << all.compared << " faces of " << meshes << " meshes below "
            << folder.filename() << " equal the scan's, " << all.ties << " ties, " << all.wrong
            << " wrong\n";
}

TEST(DirectionTableMeshes, DemoRobot) {
  compareMeshesBelow("../launch/demo/meshes");
}

TEST(DirectionTableMeshes, RobotsAndModels) {
  const auto folder = robotsFolder();
  if (!folder) GTEST_SKIP() << "skipped: meshes of robots and models: LINK_BOUNDS_DATA is not set";
  compareMeshesBelow(*folder);
}

}  // namespace
}  // namespace link_bounds
