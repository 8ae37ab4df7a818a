// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever goes wrong with the mesh of one object is the reason of that object.
#include "node/loading/object_meshes.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

TriangleMesh readTriangle(const MeshFile&) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

std::string folderOf(const std::string& package) {
  if (package == "large") throw std::bad_alloc();
  if (package == "odd") throw std::logic_error("it is odd");
  return "";
}

TEST(ObjectMeshes, AnExceptionIsTheReasonOfThatMeshAlone) {
  const TemporaryFolder folder;
  MeshStore store(readTriangle);
  const auto meshes =
      loadObjectMeshes({"package://large/a.stl", "file://" + folder.write("good.stl"),
                        "package://odd/a.stl", "package://missing/a.stl"},
                       folderOf, store);
  ASSERT_EQ(meshes.size(), 4u);
  EXPECT_FALSE(meshes[0].points);
  EXPECT_EQ(meshes[0].error,
            "it does not fit into memory; end some other programs and call ~reload");
  EXPECT_TRUE(meshes[1].points);
  EXPECT_EQ(meshes[1].error, "");
  EXPECT_EQ(meshes[2].error, "unexpected: it is odd; call ~reload");
  EXPECT_NE(meshes[3].error.find("there is no package"), std::string::npos);
}

}  // namespace
}  // namespace link_bounds
