// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Mesh URIs that are refused: outside their package, not a regular file, or not found.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "link_bounds/robot/mesh/mesh_uri.h"
#include "testing/other_user.h"
#include "testing/refusal.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

class MeshUriRefusals : public testing::Test {
 protected:
  MeshUriRefusals() {
    folder_.write("arm/meshes/link.stl");
    folder_.write("arm_secret/key.stl");
    folder_.write("key.stl");
  }

  /// The error's text; "" if the URI was accepted.
  std::string refusal(const std::string& uri) const {
    const auto package_path = [this](const std::string& package) {
      return package == "arm" ? folder_ / "arm" : std::string();
    };
    return refusalOf<MeshError>([&] { resolveMeshUri(uri, package_path); });
  }

  void expectRefused(const std::string& uri, const std::string& reason) const {
    EXPECT_NE(refusal(uri).find(reason), std::string::npos)
        << "\"" << uri << "\" gave \"" << refusal(uri) << "\"";
  }

  TemporaryFolder folder_;
};

TEST_F(MeshUriRefusals, DotsThatLeaveThePackage) {
  expectRefused("package://arm/../key.stl", "outside package \"arm\"");
  expectRefused("package://arm/meshes/../../key.stl", "outside package");
  expectRefused("package://arm/%2e%2e/key.stl", "outside package");
  expectRefused("package://arm/..%2fkey.stl", "outside package");
  expectRefused("package://arm/../../../../../../../../etc/hostname", "outside package");
}

TEST_F(MeshUriRefusals, AFolderThatMayNotBeEntered) {
  fs::permissions(folder_ / "arm/meshes", fs::perms::none);
  {
    const OtherUser nobody;
    expectRefused("package://arm/meshes/link.stl", "; allow this user to enter its folders");
  }
  fs::permissions(folder_ / "arm/meshes", fs::perms::owner_all);
}

TEST_F(MeshUriRefusals, ANeighbourWhoseNameBeginsAlike) {
  expectRefused("package://arm/../arm_secret/key.stl", "outside package");
}

TEST_F(MeshUriRefusals, ASymlinkThatLeavesThePackage) {
  fs::create_symlink(folder_ / "key.stl", folder_ / "arm/meshes/innocent.stl");
  fs::create_directory_symlink(folder_ / "arm_secret", folder_ / "arm/textures");
  expectRefused("package://arm/meshes/innocent.stl", "outside package");
  expectRefused("package://arm/textures/key.stl", "outside package");
}

TEST_F(MeshUriRefusals, ButNotASymlinkInsideThePackage) {
  fs::create_symlink("link.stl", folder_ / "arm/meshes/alias.stl");
  EXPECT_EQ(refusal("package://arm/meshes/alias.stl"), "");
}

TEST_F(MeshUriRefusals, NorDotsThatLeaveAndComeBack) {
  EXPECT_EQ(refusal("package://arm/../arm/meshes/link.stl"), "");
}

TEST_F(MeshUriRefusals, AFifoIsRefusedWithoutBeingOpened) {
  ASSERT_EQ(mkfifo((folder_ / "arm/pipe.stl").c_str(), 0600), 0);
  expectRefused("package://arm/pipe.stl", "not a regular file");
  expectRefused("file://" + (folder_ / "arm/pipe.stl"), "not a regular file");
}

TEST_F(MeshUriRefusals, APathWithoutAScheme) {
  expectRefused("/tmp/x.stl", "write file:///tmp/x.stl");
}

TEST_F(MeshUriRefusals, ADevice) {
  expectRefused("file:///dev/zero", "not a regular file");
}

TEST_F(MeshUriRefusals, AFolder) {
  expectRefused("package://arm/meshes", "not a regular file");
  expectRefused("package://arm/", "not a regular file");
  expectRefused("file:///", "not a regular file");
}

TEST_F(MeshUriRefusals, AMissingFile) {
  expectRefused("package://arm/meshes/missing.stl", "cannot find");
  expectRefused("file://" + (folder_ / "missing.stl"), folder_ / "missing.stl");
  expectRefused("package://arm/meshes/link.stl/link.stl", "cannot find");
}

TEST_F(MeshUriRefusals, ADanglingOrCircularSymlink) {
  fs::create_symlink("nowhere.stl", folder_ / "arm/dangling.stl");
  fs::create_symlink("circle.stl", folder_ / "arm/circle.stl");
  expectRefused("package://arm/dangling.stl", "cannot find");
  expectRefused("package://arm/circle.stl", "cannot find");
}

TEST_F(MeshUriRefusals, APackageThatDoesNotExist) {
  expectRefused("package://leg/meshes/link.stl", "no package \"leg\"");
  expectRefused("package://leg/meshes/link.stl", "ROS_PACKAGE_PATH");
}

TEST_F(MeshUriRefusals, APackageWhoseFolderIsGone) {
  const auto gone = [this](const std::string&) { return folder_ / "gone"; };
  EXPECT_THROW(resolveMeshUri("package://arm/link.stl", gone), MeshError);
}

TEST_F(MeshUriRefusals, AUriThatNamesNoPackage) {
  expectRefused("package:///meshes/link.stl", "names no package");
  expectRefused("package://", "names no package");
  expectRefused("package://arm", "names no package");
}

TEST_F(MeshUriRefusals, AFileUriThatIsNotAbsolute) {
  expectRefused("file://link.stl", "file:///");
  expectRefused("file://", "file:///");
}

TEST_F(MeshUriRefusals, AZeroByte) {
  expectRefused("package://arm/meshes/link.stl%00.png", "zero byte");
  expectRefused("file:///%00", "zero byte");
}

TEST_F(MeshUriRefusals, SchemesThatAreNotFiles) {
  for (const char* uri : {"http://example.org/link.stl", "https://example.org/link.stl",
                          "ftp://example.org/link.stl", "model://arm/link.stl"}) {
    expectRefused(uri, "not supported; use package:// or file://");
  }
}

TEST_F(MeshUriRefusals, AnEmptyName) {
  expectRefused("", "no file name");
}

TEST_F(MeshUriRefusals, ANameLongerThanTheSystemAllows) {
  expectRefused("package://arm/" + std::string(100000, 'x'), "cannot find");
}

}  // namespace
}  // namespace link_bounds
