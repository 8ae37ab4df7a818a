// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Packages are found as rospack finds them, and a manifest that cannot be read harms no other.
#include "packages/package_path.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "testing/refusal.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

class PackagePathTest : public testing::Test {
 protected:
  /// rospack would keep a file in the home of ROS.
  void SetUp() override {
    setenv("ROS_HOME", (folder_ / "home").c_str(), 1);
    setPath(folder_ / "first" + ":" + folder_ / "second");
  }

  static void setPath(const std::string& path) { setenv("ROS_PACKAGE_PATH", path.c_str(), 1); }

  void write(const std::string& folder, const std::string& manifest) const {
    folder_.write(folder + "/package.xml", manifest);
  }

  void writePackage(const std::string& folder, const std::string& name) const {
    write(folder, "<package format=\"2\"><name>" + name + "</name></package>");
  }

  void expectFound(const std::string& package, const std::string& folder) const {
    EXPECT_EQ(rosPackages()(package), folder_ / folder);
  }

  TemporaryFolder folder_;
};

TEST_F(PackagePathTest, ByTheNameInTheManifest) {
  writePackage("first/deep/down/folder", "body");
  expectFound("body", "first/deep/down/folder");
  EXPECT_EQ(rosPackages()("folder"), "");
  EXPECT_EQ(rosPackages()(""), "");
}

TEST_F(PackagePathTest, OfOldPackagesByTheFolder) {
  folder_.write("first/old/manifest.xml", "<package/>");
  expectFound("old", "first/old");
}

TEST_F(PackagePathTest, ThePathItselfMayBeAPackage) {
  writePackage("first", "body");
  expectFound("body", "first");
}

TEST_F(PackagePathTest, TheFirstOfTheSameNameCounts) {
  writePackage("second/a", "body");
  writePackage("first/b", "body");
  expectFound("body", "first/b");
}

TEST_F(PackagePathTest, NotInHiddenOrIgnoredFoldersNorInPackages) {
  writePackage("first/.hidden/a", "a");
  writePackage("first/ignored/b", "b");
  folder_.write("first/ignored/CATKIN_IGNORE");
  writePackage("first/shallow/c", "c");
  folder_.write("first/shallow/rospack_nosubdirs");
  writePackage("first/outer", "outer");
  writePackage("first/outer/inner", "inner");
  for (const char* const name : {"a", "b", "c", "inner"})
    EXPECT_EQ(rosPackages()(name), "") << name;
  expectFound("outer", "first/outer");
}

TEST_F(PackagePathTest, LinksThatLeadBackAndFoldersWithoutEndEndTheSearch) {
  writePackage("first/z", "body");
  std::filesystem::create_directories(folder_ / "first/a");
  std::filesystem::create_directory_symlink("..", folder_ / "first/a/up");
  std::string deep = "first/b";
  for (int i = 1; i <= 1200; ++i) {
    deep += "/d";
    if (i % 600 == 0) std::filesystem::create_directories(folder_ / deep);
  }
  expectFound("body", "first/z");
}

TEST_F(PackagePathTest, WithoutAPathOrWithOneThatLeadsNowhere) {
  setPath("::/no/such/folder:");
  EXPECT_EQ(rosPackages()("no_such_package"), "");
  unsetenv("ROS_PACKAGE_PATH");
  EXPECT_EQ(rosPackages()("no_such_package"), "");
}

/// Well-formed, but not what a package.xml must hold; some end rospack by a segmentation fault.
TEST_F(PackagePathTest, AnOddManifestHarmsNoOtherPackage) {
  writePackage("second/body", "body");
  for (const char* const manifest :
       {"<foo/>", "<package/>", "<package><name/></package>",
        "<package><name><b/></name></package>",
        "<package><name>odd</name><depend/><exec_depend/><run_depend/></package>"}) {
    write("first/odd", manifest);
    expectFound("body", "second/body");
    expectFound("odd", "first/odd");
  }
}

TEST_F(PackagePathTest, ABrokenManifestHarmsNoOtherPackage) {
  writePackage("second/body", "body");
  for (const char* const manifest : {"", "prose", "<package><name>broken", "<a></b>"}) {
    write("first/broken", manifest);
    expectFound("body", "second/body");
  }
}

TEST_F(PackagePathTest, ItIsNamedWhereAPackageIsMissed) {
  write("first/aaa", "prose");
  write("first/broken", "<package><name>broken");
  write("second/zzz", "prose");
  const PackagePath packages = rosPackages();
  for (int i = 0; i < 2; ++i) {
    const std::string reason = refusalOf<MeshError>([&] { packages("broken"); });
    EXPECT_NE(reason.find("there is no package \"broken\""), std::string::npos) << reason;
    EXPECT_NE(reason.find(folder_ / "first/broken/package.xml"), std::string::npos) << reason;
    EXPECT_NE(reason.find("repair"), std::string::npos) << reason;
  }
}

TEST_F(PackagePathTest, AManifestThatIsNoFileIsNotOpened) {
  std::filesystem::create_directories(folder_ / "first/odd");
  std::filesystem::create_symlink("/dev/zero", folder_ / "first/odd/package.xml");
  writePackage("second/body", "body");
  expectFound("body", "second/body");
}

TEST_F(PackagePathTest, NothingIsWritten) {
  writePackage("first/body", "body");
  expectFound("body", "first/body");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "home"));
}

}  // namespace
}  // namespace link_bounds
