// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Robots by their URDFs, as the library reads them; models and demo meshes by their files.
#include "bench/common/mesh_choice.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <set>

#include "geometry/support/table/direction_table.h"
#include "link_bounds/robot/mesh/mesh_uri.h"
#include "link_bounds/robot/urdf/robot.h"
#include "robot/worker/mesh_import.h"
#include "testing/robot_files.h"

namespace link_bounds::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSharedMeshes = 16;
constexpr char kModels[] = "stanford_models";

/// Small and large, with few and many points that can be extreme, of three robots.
constexpr std::array<const char*, 6> kQuickRobotMeshes{
    "franka_description/meshes/visual/link0.dae",
    "franka_description/meshes/visual/link6.dae",
    "pr2_description/meshes/base_v0/base.dae",
    "ur_description/meshes/ur5e/visual/base.dae",
    "ur_description/meshes/ur5e/visual/upperarm.dae",
    "ur_description/meshes/ur5e/visual/wrist1.dae"};
constexpr std::array<const char*, 2> kQuickModels{"stanford_models/meshes/dragon_vrip_res2.ply",
                                                  "stanford_models/meshes/dragon_vrip_res3.ply"};

template <class Names>
bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The files in a folder, in the order of their names.
std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Reads files that belong to one folder, which is that of packages and the one names start at.
class Reader {
 public:
  Reader(const fs::path& folder, bool quick) : folder_(fs::canonical(folder)), quick_(quick) {}

  void addRobot(const fs::path& urdf, MeasuredMeshes& meshes) try {
    for (const Link& link : parseRobot(textOf(urdf)).links) {
      for (const Element& element : link.elements) {
        if (element.purpose == Purpose::kVisual && !element.mesh_uri.empty())
          addUri(element.mesh_uri, meshes);
      }
    }
  } catch (const RobotError& error) {
    std::cout << "left out " << urdf.string() << ": " << error.what() << "\n";
  }

  void addFile(const fs::path& path, const std::string& kind, MeasuredMeshes& meshes) try {
    meshes.push_back(measuredMesh(fs::relative(path, folder_).string(), kind,
                                  importMesh({path.string(), path.parent_path().string()})));
  } catch (const MeshError& error) {
    std::cout << "left out " << path.string() << ": " << error.what() << "\n";
  }

 private:
  void addUri(const std::string& uri, MeasuredMeshes& meshes) try {
    const auto package_path = [this](const std::string& package) { return folder_ / package; };
    const std::string path = resolveMeshUri(uri, package_path).path;
    const bool is_wanted = !quick_ || contains(kQuickRobotMeshes, fs::relative(path, folder_));
    if (is_wanted && seen_.insert(path).second) addFile(path, "robot", meshes);
  } catch (const MeshError& error) {
    std::cout << "left out " << uri << ": " << error.what() << "\n";
  }

  fs::path folder_;
  bool quick_;
  std::set<std::string> seen_;
};

void addModels(const fs::path& folder, bool quick, Reader& reader, MeasuredMeshes& meshes) {
  const fs::path models = folder / kModels / "meshes";
  if (!fs::exists(models)) return;
  for (const fs::path& path : files(models)) {
    if (!quick || contains(kQuickModels, fs::relative(path, folder)))
      reader.addFile(path, "model", meshes);
  }
}

}  // namespace

MeasuredMeshes chooseMeshes(bool quick) {
  MeasuredMeshes meshes;
  const auto folder = robotsFolder();
  if (!folder) {
    std::cout << "LINK_BOUNDS_DATA is not set: robots and scanned models are left out, the demo's "
                 "meshes stand in for robots\n";
    const fs::path demo = fs::canonical(LINK_BOUNDS_PACKAGE "/launch/demo/meshes");
    Reader reader(demo, quick);
    for (const fs::path& path : files(demo)) {
      if (path.extension() != ".mtl") reader.addFile(path, "robot", meshes);
    }
  } else {
    Reader reader(*folder, quick);
    for (const RobotFile& file : publicRobotFiles())
      reader.addRobot(file.urdf, meshes);
    addModels(*folder, quick, reader, meshes);
  }
  if (quick) std::cout << "--quick: only some robot meshes and models\n";
  addSyntheticMeshes(meshes);
  return meshes;
}

MeasuredMeshes sharedMeshes(bool quick) {
  MeasuredMeshes meshes = chooseMeshes(quick);
  const auto end = std::remove_if(meshes.begin(), meshes.end(), [](const MeasuredMesh& mesh) {
    return mesh.kind != "robot" || mesh.points->size() <= kScannedPoints;
  });
  meshes.erase(end, meshes.end());
  const std::size_t wanted = std::min(meshes.size(), kSharedMeshes);
  MeasuredMeshes chosen;
  for (std::size_t i = 0; i < wanted; ++i)
    chosen.push_back(std::move(meshes[i * meshes.size() / wanted]));
  return chosen;
}

}  // namespace link_bounds::bench
