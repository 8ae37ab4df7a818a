// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// File access for assimp that cannot leave the mesh's folder or package.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <string>

namespace link_bounds {

/// Opens for reading only, and only regular files whose real path lies below `root`: a mesh may
/// name any file of the machine as its material or buffer.
class ConfinedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ConfinedFiles(std::string root) : root_(std::move(root)) {}

  bool Exists(const char* path) const override;
  Assimp::IOStream* Open(const char* path, const char* mode) override;

 private:
  bool isAllowed(const char* path) const;

  std::string root_;
};

}  // namespace link_bounds
