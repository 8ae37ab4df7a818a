// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Schemes, percent-escapes, and the check that the mesh of a package lies in its folder.
#include "link_bounds/robot/mesh/mesh_uri.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "robot/mesh/percent_decoded.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

constexpr char kPackageScheme[] = "package://";
constexpr char kFileScheme[] = "file://";

bool startsWith(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

/// Throws MeshError if no file can have that name.
std::string decodedName(const std::string& text) {
  std::string name = percentDecoded(text);
  if (name.find('\0') != std::string::npos) throw MeshError("the URI contains a zero byte");
  return name;
}

fs::path realPath(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error) {
    const bool is_forbidden = error == std::errc::permission_denied;
    throw MeshError("cannot find " + path.string() + " (" + error.message() + "); " +
                    (is_forbidden ? "allow this user to enter its folders"
                                  : "correct the path or install the file"));
  }
  return real;
}

MeshFile checkedFile(const fs::path& path, const fs::path& root) {
  const fs::path real = realPath(path);
  std::error_code error;
  if (!fs::is_regular_file(real, error)) {
    throw MeshError(real.string() + " is not a regular file; name a mesh file");
  }
  return {real.string(), (root.empty() ? real.parent_path() : root).string()};
}

MeshFile resolvePackageUri(const std::string& rest, const PackagePath& package_path) {
  const std::size_t slash = rest.find('/');
  const std::string package = rest.substr(0, slash);
  if (package.empty() || slash == std::string::npos) {
    throw MeshError("the URI names no package; write package://PACKAGE/PATH");
  }
  const std::string folder = package_path ? package_path(package) : "";
  if (folder.empty()) {
    throw MeshError("there is no package \"" + package +
                    "\"; install it or add its folder to ROS_PACKAGE_PATH");
  }
  const fs::path root = realPath(folder);
  const fs::path path = realPath(fs::path(folder + "/" + decodedName(rest.substr(slash + 1))));
  if (!isBelow(root, path)) {
    throw MeshError(path.string() + " lies outside package \"" + package +
                    "\"; move it into the package or name it by file://");
  }
  return checkedFile(path, root);
}

MeshFile resolveFileUri(const std::string& rest) {
  if (rest.empty() || rest.front() != '/') {
    throw MeshError("a file URI needs an absolute path; write file:///PATH");
  }
  return checkedFile(decodedName(rest), {});
}

}  // namespace

bool isBelow(const fs::path& folder, const fs::path& path) {
  const fs::path::iterator other =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first;
  return other == folder.end() || other->empty();  // the last part is empty after a slash at the
                                                   // end
}

MeshFile resolveMeshUri(const std::string& uri, const PackagePath& package_path,
                        const std::string& base_folder) {
  if (uri.empty()) throw MeshError("the mesh has no file name");
  if (startsWith(uri, kPackageScheme)) {
    return resolvePackageUri(uri.substr(sizeof(kPackageScheme) - 1), package_path);
  }
  if (startsWith(uri, kFileScheme)) return resolveFileUri(uri.substr(sizeof(kFileScheme) - 1));
  if (uri.find("://") != std::string::npos) {
    throw MeshError("the scheme of this URI is not supported; use package:// or file://");
  }
  if (uri[0] == '/' && base_folder.empty())
    throw MeshError("it is a path without a scheme; write file://" + uri);
  if (base_folder.empty()) {
    throw MeshError(
        "it is a relative name without a folder to start from; use package:// or file://");
  }
  return checkedFile(fs::path(base_folder) / decodedName(uri), {});
}

}  // namespace link_bounds
