// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Mesh URIs that are accepted: schemes, spaces, percent-escapes, relative names.
#include "link_bounds/robot/mesh/mesh_uri.h"

#include <gtest/gtest.h>

#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

class MeshUri : public testing::Test {
 protected:
  MeshFile resolve(const std::string& uri, const std::string& base_folder = "") const {
    const auto package_path = [this](const std::string& package) {
      return package == "arm" ? folder_ / "arm" : std::string();
    };
    return resolveMeshUri(uri, package_path, base_folder);
  }

  TemporaryFolder folder_;
};

TEST_F(MeshUri, PackageSchemeNamesAFileOfThePackage) {
  const std::string path = folder_.write("arm/meshes/link.stl");
  const MeshFile file = resolve("package://arm/meshes/link.stl");
  EXPECT_EQ(file.path, path);
  EXPECT_EQ(file.root, folder_ / "arm") << "a mesh may name its package's textures";
}

TEST_F(MeshUri, ASlashAtTheEndOfAFolderCountsNothing) {
  EXPECT_TRUE(isBelow("/a/", "/a/b"));
  EXPECT_TRUE(isBelow("/a", "/a/b"));
  EXPECT_FALSE(isBelow("/a/", "/ab"));
  EXPECT_FALSE(isBelow("/a/c/", "/a/b"));
}

TEST_F(MeshUri, FileSchemeNamesAnAbsolutePath) {
  const std::string path = folder_.write("somewhere/link.stl");
  const MeshFile file = resolve("file://" + path);
  EXPECT_EQ(file.path, path);
  EXPECT_EQ(file.root, folder_ / "somewhere") << "a mesh may name what lies beside it";
}

TEST_F(MeshUri, PercentEscapesStandForTheirByte) {
  const std::string path = folder_.write("arm/my link+\xc3\xa9.stl");
  EXPECT_EQ(resolve("package://arm/my%20link%2B%C3%a9.stl").path, path);
  EXPECT_EQ(resolve("file://" + folder_.path().string() + "/arm/my%20link+%c3%A9.stl").path, path);
}

TEST_F(MeshUri, SpacesMayBeWrittenAsTheyAre) {
  const std::string path = folder_.write("arm/my link.stl");
  EXPECT_EQ(resolve("package://arm/my link.stl").path, path);
  EXPECT_EQ(resolve("file://" + path).path, path);
}

TEST_F(MeshUri, APercentSignWithoutTwoDigitsStandsForItself) {
  for (const char* name : {"a%zz.stl", "b%4.stl", "c%.stl", "d%4", "e%"}) {
    const std::string path = folder_.write(std::string("arm/") + name);
    EXPECT_EQ(resolve(std::string("package://arm/") + name).path, path);
  }
}

TEST_F(MeshUri, AnEscapedPercentSignIsNotDecodedTwice) {
  const std::string path = folder_.write("arm/a%20b.stl");
  EXPECT_EQ(resolve("package://arm/a%2520b.stl").path, path);
}

TEST_F(MeshUri, DotsInsideThePackageAreFine) {
  const std::string path = folder_.write("arm/meshes/link.stl");
  folder_.write("arm/urdf/arm.urdf");
  EXPECT_EQ(resolve("package://arm/urdf/../meshes/./link.stl").path, path);
  EXPECT_EQ(resolve("package://arm//meshes//link.stl").path, path);
}

TEST_F(MeshUri, RelativeNamesStartAtTheBaseFolder) {
  const std::string path = folder_.write("robot/meshes/link.stl");
  EXPECT_EQ(resolve("meshes/link.stl", folder_ / "robot").path, path);
  EXPECT_EQ(resolve("../robot/meshes/link.stl", folder_ / "robot").path, path);
  EXPECT_EQ(resolve("meshes/link.stl", folder_ / "robot").root, folder_ / "robot/meshes");
}

TEST_F(MeshUri, AbsoluteNamesCountAsRelativeToABaseFolder) {
  const std::string path = folder_.write("link.stl");
  EXPECT_EQ(resolve(path, folder_ / "robot").path, path);
}

TEST_F(MeshUri, RelativeNamesWithoutABaseFolderAreRefused) {
  folder_.write("link.stl");
  EXPECT_THROW(resolve("link.stl"), MeshError);
  EXPECT_THROW(resolve(folder_ / "link.stl"), MeshError);
}

TEST_F(MeshUri, TheNameIsTheSameByWhicheverWayItIsReached) {
  const std::string path = folder_.write("arm/meshes/link.stl");
  std::filesystem::create_symlink(folder_ / "arm", folder_ / "alias");
  EXPECT_EQ(resolve("file://" + (folder_ / "alias/meshes/link.stl")).path, path);
  EXPECT_EQ(resolve("alias/meshes/link.stl", folder_.path().string()).path, path);
}

TEST_F(MeshUri, APackageFolderMayItselfBeALink) {
  const std::string path = folder_.write("source/link.stl");
  std::filesystem::create_directory_symlink(folder_ / "source", folder_ / "arm");
  const MeshFile file = resolve("package://arm/link.stl");
  EXPECT_EQ(file.path, path);
  EXPECT_EQ(file.root, folder_ / "source");
}

}  // namespace
}  // namespace link_bounds
