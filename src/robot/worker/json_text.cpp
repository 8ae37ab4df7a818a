// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Text that is not JSON is left to assimp, which refuses it.
#include "robot/worker/json_text.h"

#include <algorithm>
#include <cstdlib>

#include "link_bounds/robot/worker/mesh_process.h"

namespace link_bounds {
namespace {

constexpr int kMaxDepth = 500;

class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  Json value(int depth = 0) {
    if (depth > kMaxDepth) throw MeshError("its JSON is nested too deeply");
    Json result;
    skipBlanks();
    if (peek() == '"') {
      result.text = string();
      result.is_string = true;
    } else if (peek() == '{' || peek() == '[') {
      result.members = members(depth);
    } else {
      const std::size_t end = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
      result.text = text_.substr(at_, end - at_);
      at_ = end;
    }
    return result;
  }

 private:
  std::vector<std::pair<std::string, Json>> members(int depth) {
    const bool is_object = take() == '{';
    std::vector<std::pair<std::string, Json>> result;
    for (skipBlanks(); peek() != '}' && peek() != ']'; skipBlanks()) {
      std::string name = is_object ? string() : std::to_string(result.size());
      skipBlanks();
      if (is_object && peek() == ':') take();
      result.emplace_back(std::move(name), value(depth + 1));
      skipBlanks();
      if (peek() == ',') take();
    }
    take();
    return result;
  }

  /// Characters that are not ASCII may be misread: no name that is checked has one.
  std::string string() {
    std::string result;
    take();
    for (char c = take(); c != '"'; c = take()) {
      result += c == '\\' ? escaped() : c;
    }
    return result;
  }

  /// The character of an escape sequence, whose backslash was taken.
  char escaped() {
    const char c = take();
    if (c != 'u') return c;
    const std::string digits(text_.substr(at_, 4));
    for (int i = 0; i < 4; ++i)
      take();
    return static_cast<char>(std::strtoul(digits.c_str(), nullptr, 16));
  }

  void skipBlanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  char peek() const {
    if (at_ >= text_.size()) throw MeshError("its JSON does not end, as if it was cut off");
    return text_[at_];
  }

  char take() {
    const char c = peek();
    ++at_;
    return c;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

const Json& Json::operator[](std::string_view name) const {
  static const Json none;
  for (const auto& [known, value] : members)
    if (known == name) return value;
  return none;
}

bool Json::has(std::string_view name) const {
  return std::any_of(members.begin(), members.end(),
                     [name](const auto& member) { return member.first == name; });
}

Json parseJson(std::string_view text) {
  return JsonReader(text).value();
}

}  // namespace link_bounds
