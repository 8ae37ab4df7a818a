// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Valid mesh files to mutate. They are small, so that most mutations have an effect.
#pragma once

#include <string>
#include <vector>

namespace link_bounds {

struct MeshSeed {
  std::string format;  ///< its name in the table of outcomes
  std::string extension;
  std::string content;
  bool is_text;
};

/// One of each format that robots use, all of the same irregular octahedron; the Collada file has
/// two of them, in inches, below nested nodes.
std::vector<MeshSeed> meshSeeds();

/// A GLB file of these two chunks, with correct sizes.
std::string glb(std::string json, std::string binary);

/// The first chunk of a GLB file.
std::string jsonOf(const std::string& glb);

/// The second chunk of a GLB file.
std::string binaryOf(const std::string& glb);

}  // namespace link_bounds
