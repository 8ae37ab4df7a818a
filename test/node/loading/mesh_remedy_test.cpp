// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each fault has a remedy, and only that of the node names parameters and ~reload.
#include "node/loading/mesh_remedy.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

bool namesTheNode(const std::string& remedy) {
  for (const char* word : {"mesh_timeout", "max_mesh_bytes", "reload"}) {
    if (remedy.find(word) != std::string::npos) return true;
  }
  return false;
}

TEST(MeshRemedy, ThereIsOneForEachFault) {
  for (int i = 0; i <= static_cast<int>(kLastMeshFault); ++i) {
    const auto fault = static_cast<MeshFault>(i);
    EXPECT_NE(plainRemedy(fault), "") << i;
    EXPECT_NE(nodeRemedy(fault), "") << i;
    EXPECT_FALSE(namesTheNode(plainRemedy(fault))) << plainRemedy(fault);
  }
}

TEST(MeshRemedy, TheNodeNamesTheParameterThatHelps) {
  EXPECT_EQ(nodeRemedy(MeshFault::kTooLarge), "raise max_mesh_bytes or simplify the mesh");
  EXPECT_EQ(nodeRemedy(MeshFault::kTooSlow), "raise mesh_timeout or simplify the mesh");
  EXPECT_EQ(nodeRemedy(MeshFault::kFile), "repair or replace the file");
  EXPECT_FALSE(namesTheNode(nodeRemedy(MeshFault::kMemory))) << "no parameter sets that limit";
}

TEST(MeshRemedy, NobodyIsSentToReplaceAFileThatMayBeSound) {
  for (int i = 1; i <= static_cast<int>(kLastMeshFault); ++i) {
    for (const std::string& remedy :
         {plainRemedy(static_cast<MeshFault>(i)), nodeRemedy(static_cast<MeshFault>(i))})
      EXPECT_EQ(remedy.find("replace"), std::string::npos) << remedy;
  }
}

}  // namespace
}  // namespace link_bounds
