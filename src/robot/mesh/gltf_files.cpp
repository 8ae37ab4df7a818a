// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Only looks at strings: whether the text is JSON is the business of who reads the mesh.
#include "robot/mesh/gltf_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "robot/mesh/percent_decoded.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxName = 4096;  // bytes; data in the text may take gigabytes

/// The characters of a regular file; none of another one, which might never end.
class Text {
 public:
  explicit Text(const std::string& path)
      : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    struct stat status {};
    is_over_ = file_ < 0 || fstat(file_, &status) != 0 || !S_ISREG(status.st_mode);
  }
  ~Text() {
    if (file_ >= 0) close(file_);
  }
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  /// False at the end.
  bool next(char& c) {
    if (at_ == count_ && !is_over_) {
      const ssize_t count = read(file_, block_.data(), block_.size());
      is_over_ = count <= 0;
      count_ = is_over_ ? 0 : static_cast<std::size_t>(count);
      at_ = 0;
    }
    if (is_over_) return false;
    c = block_[at_++];
    return true;
  }

  /// After its first quotation mark; no more than kMaxName bytes and one.
  std::string string() {
    std::string result;
    for (char c = 0; next(c) && c != '"';) {
      if (c == '\\' && !next(c)) break;  // such as "\/"
      if (result.size() <= kMaxName) result += c;
    }
    return result;
  }

 private:
  int file_;
  bool is_over_ = false;
  std::array<char, 1 << 16> block_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;
};

/// The values of all keys "uri", but those that are data.
std::vector<std::string> urisOf(const std::string& path) {
  std::vector<std::string> uris;
  Text text(path);
  std::string key;  // the last string, if only blanks and a colon came since
  bool has_colon = false;
  for (char c = 0; text.next(c);) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
    if (c == '"') {
      std::string string = text.string();
      if (has_colon && key == "uri" && string.size() <= kMaxName && string.rfind("data:", 0) != 0)
        uris.push_back(string);
      key = std::move(string);
      has_colon = false;
    } else {
      has_colon = c == ':';
      if (!has_colon) key.clear();
    }
  }
  return uris;
}

bool isGltf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".gltf";
}

}  // namespace

std::vector<std::string> filesOf(const std::string& path) {
  std::vector<std::string> files{path};
  if (!isGltf(path)) return files;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& uri : urisOf(path)) {
    for (const std::string& name : {uri, percentDecoded(uri)}) {
      const std::string named = (folder / name).string();
      if (std::find(files.begin(), files.end(), named) == files.end()) files.push_back(named);
    }
  }
  return files;
}

}  // namespace link_bounds
