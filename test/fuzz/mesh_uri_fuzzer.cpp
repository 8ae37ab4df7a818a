// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Any text as the URI of a mesh must give a regular file at a permitted place, or MeshError.
#include <sys/stat.h>

#include <filesystem>

#include "fuzzing.h"
#include "link_bounds/robot/mesh/mesh_uri.h"
#include "testing/temporary_folder.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

/// A package with every kind of file and link, and a file outside that no URI may lead to.
class Packages {
 public:
  Packages() {
    folder_.write("robot/meshes/arm.stl", "solid");
    folder_.write("robot/meshes/left arm.stl", "solid");
    folder_.write("robot/a.stl", "solid");
    folder_.write("robotics/a.stl", "solid");
    folder_.write("secret.stl", "solid");
    fs::create_symlink("arm.stl", folder_ / "robot/meshes/link.stl");
    fs::create_symlink("../secret.stl", folder_ / "robot/out.stl");
    fs::create_directory_symlink("..", folder_ / "robot/up");
    fs::create_symlink("loop.stl", folder_ / "robot/loop.stl");
    require(mkfifo((folder_ / "robot/pipe.stl").c_str(), 0600) == 0, "a pipe can be made");
  }

  std::string root() const { return folder_ / "robot"; }

  std::string find(const std::string& package) const {
    if (package == "robot") return root() + "/";
    return package == "gone" ? folder_ / "gone" : "";
  }

 private:
  TemporaryFolder folder_;
};

bool startsWith(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

void checkFile(const MeshFile& file, const std::string& uri, const Packages& packages) {
  require(startsWith(file.path, "/"), "the path is absolute");
  require(file.path.find('\0') == std::string::npos, "the path has no zero byte");
  require(fs::canonical(file.path) == file.path, "the path is real");
  require(fs::is_regular_file(fs::symlink_status(file.path)), "it is a regular file");
  require(fs::canonical(file.root) == file.root, "the root is real");
  require(startsWith(file.path, file.root == "/" ? file.root : file.root + "/"),
          "the path lies below the root");
  if (startsWith(uri, "package://")) {
    require(file.root == packages.root(), "the root is that of the package");
  }
}

}  // namespace
}  // namespace link_bounds

/// The first byte says whether plain paths are allowed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace link_bounds;
  static const Packages kPackages;
  if (size == 0) return 0;
  const std::string uri(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string base_folder = data[0] % 2 == 0 ? "" : kPackages.root();
  const auto find = [](const std::string& package) { return kPackages.find(package); };
  try {
    checkFile(resolveMeshUri(uri, find, base_folder), uri, kPackages);
  } catch (const MeshError& error) {
    require(*error.what() != '\0', "a reason is given");
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned random) {
  using namespace link_bounds;
  static const std::vector<std::string> kSeeds{"0package://robot/meshes/arm.stl",
                                               "1package://robot/meshes/left%20arm.stl",
                                               "0package://robot/meshes/../a.stl",
                                               "0package://robot/up/robotics/a.stl",
                                               "0package://robot/out.stl",
                                               "0package://robot/loop.stl",
                                               "0package://robot/pipe.stl",
                                               "0package://robot/%2e%2e/secret.stl",
                                               "0package://gone/a.stl",
                                               "0file:///etc/passwd",
                                               "1meshes/link.stl",
                                               "1../secret.stl",
                                               "1/etc/passwd",
                                               "0http://localhost/a.stl"};
  const std::size_t seed_size = seeded(kSeeds, random, data, size, max_size);
  return seed_size > 0 ? seed_size : LLVMFuzzerMutate(data, size, max_size);
}
