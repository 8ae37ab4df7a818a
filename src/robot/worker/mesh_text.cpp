// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Assimp reads a number up to its first odd character, and the rest as the next number.
#include "robot/worker/mesh_text.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace link_bounds {
namespace {

/// Max length of a word in a message.
constexpr std::size_t kMaxShown = 40;

bool isDigit(char c) {
  return '0' <= c && c <= '9';
}

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}

}  // namespace

Lines::Lines(ConfinedFiles& files, const std::string& path)
    : files_(files), file_(files.Open(path.c_str(), "rb")) {
  if (!file_) throw MeshError("it cannot be opened", MeshFault::kUnreadable);
}

std::optional<std::string_view> Lines::next(std::size_t max_size) {
  while (take(max_size)) {
    if (keeps_blank_ || hasContent()) return line_;
  }
  return std::nullopt;
}

std::string Lines::beginning(std::size_t size) {
  std::string text(size, ' ');
  text.resize(file_->Read(text.data(), 1, size));
  file_->Seek(0, aiOrigin_SET);
  return text;
}

std::string Lines::rest() {
  skipEndOfCrLf();
  std::string text(buffer_.data() + next_, end_ - next_);
  const std::size_t held = text.size();
  text.resize(held + file_->FileSize() - file_->Tell());
  text.resize(held + file_->Read(text.data() + held, 1, text.size() - held));
  next_ = end_ = 0;
  return text;
}

std::string Lines::all() {
  std::string text(file_->FileSize(), ' ');
  text.resize(file_->Read(text.data(), 1, text.size()));
  return text;
}

/// Reads the next line into line_. False at the end.
bool Lines::take(std::size_t max_size) {
  line_.clear();
  skipEndOfCrLf();
  bool is_any = false;
  while (read()) {
    is_any = true;
    const char* const begin = buffer_.data() + next_;
    const char* const last = begin + std::min(end_ - next_, max_size - line_.size());
    const char* const end = std::find_if(begin, last, isLineEnd);
    line_.append(begin, end);
    next_ += static_cast<std::size_t>(end - begin);
    if (end != last) {
      is_after_cr_ = *end == '\r';
      ++next_;
      break;
    }
    if (line_.size() == max_size) break;
  }
  if (is_any) ++number_;
  return is_any;
}

bool Lines::hasContent() const {
  const std::size_t begin = line_.find_first_not_of(" \t");
  return begin != std::string::npos && line_[begin] != comment_;
}

bool Lines::read() {
  if (next_ < end_) return true;
  next_ = 0;
  end_ = file_->Read(buffer_.data(), 1, buffer_.size());
  return end_ > 0;
}

void Lines::skipEndOfCrLf() {
  if (is_after_cr_ && read() && buffer_[next_] == '\n') ++next_;
  is_after_cr_ = false;
}

std::string_view Words::next() {
  const auto begin = std::find_if_not(rest_.begin(), rest_.end(), isBlank);
  const auto end = std::find_if(begin, rest_.end(), isBlank);
  const auto at = static_cast<std::size_t>(begin - rest_.begin());
  const auto size = static_cast<std::size_t>(end - begin);
  const std::string_view word = rest_.substr(at, size);
  rest_.remove_prefix(at + size);
  return word;
}

std::size_t Words::countNumbers(const std::string& place, char comment) {
  std::size_t count = 0;
  for (std::string_view word = next(); !word.empty() && word[0] != comment; word = next()) {
    requireNumber(word, place);
    ++count;
  }
  return count;
}

bool isNumber(std::string_view word) {
  const char* c = word.data();
  const char* const end = c + word.size();
  const auto skipDigits = [&] {
    const char* const begin = c;
    while (c != end && isDigit(*c))
      ++c;
    return c != begin;
  };
  if (c != end && (*c == '-' || *c == '+')) ++c;
  if (c != end && !isDigit(*c) && *c != '.' && *c != ',') {
    const std::string name = inSmallLetters(std::string(c, end));
    return name == "nan" || name == "inf" || name == "infinity";
  }
  bool has_digits = skipDigits();
  if (c != end && (*c == '.' || *c == ',')) {
    const bool is_comma = *c == ',';
    ++c;
    const bool has_decimals = skipDigits();
    if (!has_decimals && is_comma) return false;
    has_digits = has_digits || has_decimals;
  }
  if (!has_digits) return false;
  if (c != end && (*c == 'e' || *c == 'E')) {
    ++c;
    if (c != end && (*c == '-' || *c == '+')) ++c;
    if (!skipDigits()) return false;
  }
  return c == end;
}

bool isIndex(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), isDigit) &&
         countOf(word) <= std::numeric_limits<std::int32_t>::max();
}

std::size_t countOf(std::string_view word) {
  return std::strtoull(std::string(word).c_str(), nullptr, 10);
}

std::string inQuotes(std::string_view word) {
  std::string shown(word.substr(0, kMaxShown));
  std::replace(shown.begin(), shown.end(), '\0', '?');  // what() ends there
  return "\"" + shown + "\"";
}

void requireNumber(std::string_view word, const std::string& place) {
  if (!isNumber(word)) throw MeshError(inQuotes(word) + " is no real number, in " + place);
}

void requireIndex(std::string_view word, const std::string& place) {
  if (!isIndex(word)) throw MeshError(inQuotes(word) + " is no index of a vertex, in " + place);
}

std::string inSmallLetters(std::string text) {
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

void refuseCutOff(const std::string& fault) {
  throw MeshError("it " + fault + ", as if it was cut off");
}

}  // namespace link_bounds
