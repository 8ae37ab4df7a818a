// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robots of LINK_BOUNDS_DATA.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace link_bounds {

inline std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The URDF files below a folder, sorted; without the models of Stanford, which are no robots.
inline std::vector<std::filesystem::path> robotFiles(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> result;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const bool is_model = fs::relative(entry.path(), folder).string().rfind("stanford", 0) == 0;
    if (entry.path().extension() == ".urdf" && !is_model) result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace link_bounds
