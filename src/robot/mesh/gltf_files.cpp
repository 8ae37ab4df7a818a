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

constexpr std::size_t kMaxName = 4096;  // bytes

/// Of a larger text, as with data in it, only the begin is looked at, and of many URIs the first
/// ones.
constexpr std::size_t kMaxText = 16 << 20;  // bytes
constexpr std::size_t kMaxUris = 1000;

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
      is_over_ = count <= 0 || read_ > kMaxText;
      count_ = is_over_ ? 0 : static_cast<std::size_t>(count);
      read_ += count_;
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
      const bool is_escape = c == '\\';
      if (is_escape && !next(c)) break;  // such as "\/"
      if (result.size() > kMaxName) continue;
      if (is_escape && c == 'u') {
        addUnit(codeUnit(), result);
      } else {
        result += c;
      }
    }
    return result;
  }

 private:
  /// Of UTF-16, from four hexadecimal digits.
  unsigned codeUnit() {
    unsigned unit = 0;
    char c = 0;
    for (int i = 0; i < 4 && next(c); ++i)
      unit = 16 * unit + static_cast<unsigned>(std::max(hexDigit(c), 0));
    return unit;
  }

  /// As UTF-8; with the second half of a pair, which must follow.
  void addUnit(unsigned code, std::string& out) {
    const auto add = [&out](unsigned byte) { out += static_cast<char>(byte); };
    char c = 0;
    if (code >= 0xD800 && code < 0xDC00 && next(c) && next(c))
      code = 0x10000 + ((code & 0x3FF) << 10) + (codeUnit() & 0x3FF);
    if (code < 0x80) return add(code);
    if (code < 0x800) {
      add(0xC0 | code >> 6);
    } else if (code < 0x10000) {
      add(0xE0 | code >> 12);
      add(0x80 | (code >> 6 & 0x3F));
    } else {
      add(0xF0 | code >> 18);
      add(0x80 | (code >> 12 & 0x3F));
      add(0x80 | (code >> 6 & 0x3F));
    }
    add(0x80 | (code & 0x3F));
  }

  int file_;
  bool is_over_ = false;
  std::array<char, 1 << 16> block_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;
  std::size_t read_ = 0;  ///< bytes
};

/// The values of all keys "uri", but those that are data.
std::vector<std::string> urisOf(const std::string& path) {
  std::vector<std::string> uris;
  Text text(path);
  std::string key;  // the last string, if only blanks and a colon came since
  bool has_colon = false;
  for (char c = 0; uris.size() < kMaxUris && text.next(c);) {
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
