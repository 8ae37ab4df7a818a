// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The demo's robot, and those of LINK_BOUNDS_DATA.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "link_bounds/robot/mesh/mesh_uri.h"

namespace link_bounds {

inline std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

struct RobotFile {
  std::filesystem::path urdf;
  PackagePath package_path;

  std::string name() const { return urdf.stem().string(); }
};

/// Tests run in the folder test.
inline RobotFile demoRobotFile(const std::filesystem::path& urdf = "../launch/demo/demo.urdf") {
  const std::filesystem::path demo = std::filesystem::canonical(urdf);
  const std::string package = demo.parent_path().parent_path().parent_path().string();
  return {demo, [package](const std::string&) { return package; }};
}

/// Of the packages of LINK_BOUNDS_DATA; nothing where it is not set.
inline std::optional<std::filesystem::path> robotsFolder() {
  const char* const data = std::getenv("LINK_BOUNDS_DATA");
  if (!data) return std::nullopt;
  return std::filesystem::canonical(std::filesystem::path(data) / "robots");
}

/// A URDF in one of the packages of the folder.
inline RobotFile robotFile(const std::filesystem::path& folder, const std::string& urdf) {
  return {folder / urdf, [folder](const std::string& name) { return (folder / name).string(); }};
}

/// All of LINK_BOUNDS_DATA, sorted; without the models of Stanford, which are no robots.
inline std::vector<RobotFile> publicRobotFiles() {
  namespace fs = std::filesystem;
  const std::optional<fs::path> folder = robotsFolder();
  if (!folder) return {};
  std::vector<RobotFile> result;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(*folder)) {
    const std::string path = fs::relative(entry.path(), *folder).string();
    const bool is_model = path.rfind("stanford", 0) == 0;
    if (entry.path().extension() == ".urdf" && !is_model)
      result.push_back(robotFile(*folder, path));
  }
  std::sort(result.begin(), result.end(),
            [](const RobotFile& a, const RobotFile& b) { return a.urdf < b.urdf; });
  return result;
}

/// The demo's robot where LINK_BOUNDS_DATA is not set, with a note.
inline std::vector<RobotFile> robotsOrDemo(const std::filesystem::path& demo, std::ostream& notes) {
  if (robotsFolder()) return publicRobotFiles();
  notes << "LINK_BOUNDS_DATA is not set: the demo's robot stands in for public ones\n";
  return {demoRobotFile(demo)};
}

}  // namespace link_bounds
