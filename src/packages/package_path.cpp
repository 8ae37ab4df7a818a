// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches by the rules of rospack, but does not use rospack::crawl: it throws at the first
// manifest that is not XML, crashes at a manifest with an empty name, and writes a cache file.
#include "packages/package_path.h"

#include <rospack/rospack.h>
#include <sys/stat.h>
#include <tinyxml2.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "robot/urdf/trimmed.h"

namespace link_bounds {
namespace {

namespace fs = std::filesystem;

/// Max size of a manifest. Real ones have some kilobytes.
constexpr std::uintmax_t kMaxManifestBytes = 1 << 24;

/// True for the folder of Debian's ROS packages. It contains many other folders, so Debian's
/// rospack searches only one level deep.
bool isFlat(const fs::path& root) {
  return (root / "").lexically_normal() == "/usr/share/";
}

struct Content {
  std::set<std::string> files;  ///< only names that affect the search
  std::vector<fs::path> subfolders;
};

Content contentOf(const fs::path& folder) {
  static const std::set<std::string> kFiles{"CATKIN_IGNORE", "manifest.xml", "package.xml",
                                            "rospack_nosubdirs"};
  Content content;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    if (kFiles.count(name) && entry->is_regular_file(ignored)) content.files.insert(name);
    if (name.front() != '.' && entry->is_directory(ignored)) {
      content.subfolders.push_back(entry->path());
    }
  }
  return content;
}

/// The name in a package.xml, "" if it has none; nullopt if the file cannot be read.
std::optional<std::string> statedName(const fs::path& manifest) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(manifest, error);
  tinyxml2::XMLDocument document;
  if (error || size > kMaxManifestBytes ||
      document.LoadFile(manifest.c_str()) != tinyxml2::XML_SUCCESS || !document.RootElement()) {
    return std::nullopt;
  }
  const tinyxml2::XMLElement* name = document.RootElement()->FirstChildElement("name");
  const char* text = name ? name->GetText() : nullptr;
  return text ? trimmed(text) : "";
}

/// The packages along a search path.
class Packages {
 public:
  /// Visits each folder once, even if several symbolic links lead to it. If packages have the same
  /// name, the first one counts.
  void addBelow(const fs::path& root) {
    std::vector<fs::path> open{root};
    while (!open.empty()) {
      const fs::path folder = std::move(open.back());
      open.pop_back();
      if (!isNewFolder(folder)) continue;
      const Content content = contentOf(folder);
      if (content.files.count("CATKIN_IGNORE")) continue;
      if (content.files.count("package.xml")) {
        addPackage(folder);
      } else if (content.files.count("manifest.xml")) {
        folders_.emplace(folder.filename().string(), folder.string());
      } else if (!content.files.count("rospack_nosubdirs") && (folder == root || !isFlat(root))) {
        open.insert(open.end(), content.subfolders.begin(), content.subfolders.end());
      }
    }
  }

  /// The folder of a package; "" if there is no such package. Throws MeshError if the package may
  /// be one whose manifest cannot be read.
  std::string folderOf(const std::string& name) const {
    const auto found = folders_.find(name);
    if (found != folders_.end()) return found->second;
    if (broken_.empty()) return "";
    throw MeshError("there is no package \"" + name + "\", unless it is that of " +
                    brokenManifestFor(name) +
                    ", which is no readable XML; repair that file, install the package or add "
                    "its folder to ROS_PACKAGE_PATH");
  }

 private:
  bool isNewFolder(const fs::path& folder) {
    struct stat status {};
    return stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
           visited_.emplace(status.st_dev, status.st_ino).second;
  }

  /// If the manifest has no name, the package has the name of the folder.
  void addPackage(const fs::path& folder) {
    const std::optional<std::string> name = statedName(folder / "package.xml");
    if (name) {
      folders_.emplace(name->empty() ? folder.filename().string() : *name, folder.string());
    } else {
      broken_.push_back(folder / "package.xml");
    }
  }

  /// The unreadable manifest in a folder called `name`; if there is none, the first unreadable one.
  std::string brokenManifestFor(const std::string& name) const {
    for (const fs::path& manifest : broken_) {
      if (manifest.parent_path().filename() == name) return manifest.string();
    }
    return broken_.front().string();
  }

  std::map<std::string, std::string> folders_;
  std::vector<fs::path> broken_;  ///< paths of unreadable manifests
  std::set<std::pair<dev_t, ino_t>> visited_;
};

std::unique_ptr<const Packages> findPackages() {
  std::vector<std::string> search_path;
  rospack::Rospack().getSearchPathFromEnv(search_path);
  auto packages = std::make_unique<Packages>();
  for (const std::string& root : search_path)
    packages->addBelow(root);
  return packages;
}

}  // namespace

PackagePath rosPackages() {
  struct Found {
    std::once_flag once;
    std::unique_ptr<const Packages> packages;
  };
  return [found = std::make_shared<Found>()](const std::string& name) {
    std::call_once(found->once, [&] { found->packages = findPackages(); });
    return found->packages->folderOf(name);
  };
}

}  // namespace link_bounds
