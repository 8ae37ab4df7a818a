// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Resolves every path before assimp may touch it.
#include "confined_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace link_bounds {

bool ConfinedFiles::isAllowed(const char* path) const {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error || !fs::is_regular_file(real, error)) return false;
  const fs::path root(root_);
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
}

bool ConfinedFiles::Exists(const char* path) const {
  return isAllowed(path);
}

Assimp::IOStream* ConfinedFiles::Open(const char* path, const char* mode) {
  const bool reads_only = std::string(mode).find_first_of("wa+") == std::string::npos;
  return reads_only && isAllowed(path) ? DefaultIOSystem::Open(path, mode) : nullptr;
}

}  // namespace link_bounds
