// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads to the end or to a limit.
#include "tools/command_line/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "tools/command_line/options.h"

namespace link_bounds {
namespace {

/// Far above any real file; keeps an endless input from filling the memory.
constexpr std::size_t kMaxBytes = std::size_t{1} << 28;

/// The byte order mark that some editors write before UTF-8.
constexpr std::string_view kMark = "\xef\xbb\xbf";

/// Recognises UTF-16 by its byte order mark, or by a zero byte beside its first ASCII character.
bool isUtf16(const std::string& text) {
  const std::string start = text.substr(0, 2);
  return start == "\xff\xfe" || start == "\xfe\xff" ||
         (start.size() == 2 && (start[0] == '\0') != (start[1] == '\0'));
}

std::string nameOf(const std::string& file) {
  return file == "-" ? "standard input" : file;
}

}  // namespace

UsageError faultIn(const std::string& file, const std::exception& fault) {
  return UsageError(nameOf(file) + ": " + fault.what());
}

std::string readText(const std::string& file, const std::string& what) {
  const bool is_stdin = file == "-";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(
      is_stdin ? stdin : std::fopen(file.c_str(), "rb"), std::fclose);
  const std::string name = nameOf(file);
  if (!in) throw UsageError("cannot read " + name + ": " + std::strerror(errno));
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof(buffer), in.get())) {
    text.append(buffer, count);
    if (text.size() > kMaxBytes)
      throw UsageError(name + " is larger than " + std::to_string(kMaxBytes >> 20) +
                       " MiB, too large for " + what);
  }
  if (std::ferror(in.get())) throw UsageError("cannot read " + name + ": " + std::strerror(errno));
  if (isUtf16(text)) throw UsageError(name + " is UTF-16; save it as UTF-8");
  if (text.compare(0, kMark.size(), kMark) == 0) text.erase(0, kMark.size());
  return text;
}

/// Call it before readText(), which closes standard input: /dev/stdin does not exist then.
void checkOutput(const std::string& option_name, const std::string& output,
                 const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code ignored;
    const std::string name = input == "-" ? "/dev/stdin" : input;
    if (std::filesystem::equivalent(name, output, ignored))
      throw UsageError(option_name + " is " + name + ", which is read; name another file");
  }
}

bool isSameFile(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code ignored;
  // weakly_canonical() leaves a relative name as it is if the file does not exist yet.
  const auto whole = [&](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
  };
  return (!whole(a).empty() && whole(a) == whole(b)) || std::filesystem::equivalent(a, b, ignored);
}

void checkStandardInput(const std::vector<std::pair<std::string, std::string>>& inputs) {
  std::string reader;
  for (const auto& [name, file] : inputs) {
    if (file != "-") continue;
    if (!reader.empty())
      throw UsageError(reader + " and " + name +
                       " cannot both come from standard input; name a file");
    reader = name;
  }
}

std::string folderOf(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace link_bounds
