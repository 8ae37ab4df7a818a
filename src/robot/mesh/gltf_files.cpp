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
#include <set>
#include <string_view>

#include "robot/mesh/percent_decoded.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxName = 4096;  // bytes
constexpr std::string_view kScheme = "file://";

/// Of a larger text, as with data in it, only the begin is looked at, and of many URIs the first
/// ones.
constexpr std::size_t kMaxText = 16 << 20;  // bytes
constexpr std::size_t kMaxUris = 10000;
constexpr std::size_t kMaxUriBytes = 1 << 20;  // of all of them

bool isGltf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".gltf";
}

/// The JSON of a glTF file, whatever its name; no characters of another file, which might never
/// end.
class Text {
 public:
  explicit Text(const std::string& path)
      : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    struct stat status {};
    const bool is_file = file_ >= 0 && fstat(file_, &status) == 0 && S_ISREG(status.st_mode);
    is_over_ = !is_file || !(findJson() || isGltf(path));
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
      is_over_ = count <= 0 || read_ > size_;
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
  /// Goes to where it begins. False if the file does not look like glTF.
  bool findJson() {
    std::array<unsigned char, 4096> begin{};
    constexpr std::size_t kHeaders = 20;  // bytes; of a binary file, and of its JSON
    const ssize_t count = std::max<ssize_t>(pread(file_, begin.data(), begin.size(), 0), 0);
    if (count >= static_cast<ssize_t>(kHeaders) &&
        std::equal(begin.begin(), begin.begin() + 4, "glTF")) {
      std::size_t size = 0;
      for (const std::size_t byte : {15u, 14u, 13u, 12u})
        size = size << 8 | begin[byte];
      size_ = std::min(size, kMaxText);
      return lseek(file_, kHeaders, SEEK_SET) >= 0;
    }
    const auto* const end = begin.data() + count;
    constexpr std::array<unsigned char, 3> kMark{0xEF, 0xBB, 0xBF};  // some texts begin with it
    const auto* at = begin.data();
    if (count >= 3 && std::equal(kMark.begin(), kMark.end(), at)) at += 3;
    while (at != end && std::isspace(*at) != 0)
      ++at;
    return at != end && *at == '{';
  }

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
  std::size_t read_ = 0;         ///< bytes
  std::size_t size_ = kMaxText;  ///< bytes; no more blocks are read beyond
};

/// The values of all keys "uri", but those that are data.
std::vector<std::string> urisOf(const std::string& path) {
  std::vector<std::string> uris;
  Text text(path);
  std::string key;  // the last string, if only blanks and a colon came since
  bool has_colon = false;
  std::size_t bytes = 0;
  for (char c = 0; uris.size() < kMaxUris && bytes < kMaxUriBytes && text.next(c);) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) continue;
    if (c == '"') {
      std::string string = text.string();
      if (has_colon && key == "uri" && string.size() <= kMaxName && string.rfind("data:", 0) != 0) {
        uris.push_back(string);
        bytes += string.size();
      }
      key = std::move(string);
      has_colon = false;
    } else {
      has_colon = c == ':';
      if (!has_colon) key.clear();
    }
  }
  return uris;
}

/// What assimp may open for a URI, behind the folder of the glTF: as it is written, decoded,
/// without its scheme, with the separators of Windows, or the file of that name beside the glTF.
std::set<std::string> namesOf(const std::string& uri) {
  std::set<std::string> names;
  for (std::string name : {uri, percentDecoded(uri)}) {
    names.insert(name);
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.rfind(kScheme, 0) == 0) name.erase(0, kScheme.size());
    names.insert(name);
    names.insert(percentDecoded(name.substr(name.rfind('/') + 1)));
  }
  return names;
}

}  // namespace

std::vector<std::string> filesOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::set<std::string> named;
  for (const std::string& uri : urisOf(path)) {
    for (const std::string& name : namesOf(uri)) {
      named.insert((folder / name).string());
      named.insert(folder.string() + '/' + name);  // of a name that begins with a slash, too
    }
  }
  std::vector<std::string> files{path};
  files.insert(files.end(), named.begin(), named.end());
  return files;
}

}  // namespace link_bounds
