// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads once from the beginning to the end.
#include "robot/worker/xml_tags.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace link_bounds {
namespace {

constexpr char kBlanks[] = " \t\r\n";
constexpr std::string_view kCdata = "<![CDATA[";

constexpr std::pair<std::string_view, char> kNames[] = {
    {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};

/// The character of a reference, given without & and ;. 0 if it is not ASCII.
char characterOf(const std::string& reference) {
  for (const auto& [name, character] : kNames)
    if (reference == name) return character;
  if (reference.empty() || reference[0] != '#') return '\0';
  const bool is_hex = reference.substr(1, 1) == "x";
  const auto code = std::strtoul(reference.c_str() + (is_hex ? 2 : 1), nullptr, is_hex ? 16 : 10);
  return code < 128 ? static_cast<char>(code) : '\0';
}

std::string withoutReferences(std::string_view text) {
  constexpr std::size_t kMaxReference = 12;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find('&', at), text.size());
    result += text.substr(at, begin - at);
    if (begin == text.size()) break;
    const std::string_view rest = text.substr(begin + 1, kMaxReference);
    const std::size_t end = rest.find(';');
    const char character = end == rest.npos ? '\0' : characterOf(std::string(rest.substr(0, end)));
    result += character != '\0' ? character : '&';
    at = begin + (character != '\0' ? end + 2 : 1);
  }
  return result;
}

}  // namespace

bool XmlTags::next() {
  for (;;) {
    if (at_ >= xml_.size()) return false;
    const auto first = xml_.begin() + static_cast<std::ptrdiff_t>(begin_);
    line_ += std::count(first, xml_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    begin_ = at_;
    is_text_ = xml_[at_] != '<' || startsWith(kCdata);
    if (startsWith("<!--")) {
      skipBehind("-->");
    } else if (startsWith("<?")) {
      skipBehind("?>");
    } else if (startsWith(kCdata)) {
      skipBehind("]]>");
      content_ = xml_.substr(begin_ + kCdata.size(), at_ - begin_ - kCdata.size());
      content_ = content_.substr(0, content_.rfind("]]>"));
      break;
    } else if (startsWith("<!")) {  // a document type, which may have its rules in brackets
      const bool has_rules = xml_.find('[', at_) < xml_.find('>', at_);
      if (has_rules) skipBehind("]");
      skipBehind(">");
    } else if (is_text_) {
      at_ = std::min(xml_.find('<', at_), xml_.size());
      content_ = xml_.substr(begin_, at_ - begin_);
      break;
    } else {
      at_ = endOfTag();
      content_ = xml_.substr(begin_ + 1, at_ - begin_ - 1);
      if (at_ < xml_.size()) ++at_;
      const bool is_alone = !content_.empty() && content_.back() == '/';
      if (is_alone) content_.remove_suffix(1);
      is_begin_ = content_.substr(0, 1) != "/";
      is_end_ = is_alone || !is_begin_;
      if (!is_begin_) content_.remove_prefix(1);
      name_ = content_.substr(0, content_.find_first_of(kBlanks));
      return true;
    }
  }
  if (is_end_) name_ = "";
  return true;
}

std::string XmlTags::text() const {
  return withoutReferences(content_);
}

std::optional<std::string> XmlTags::attribute(std::string_view name) const {
  std::string_view rest = content_.substr(name_.size());
  for (;;) {
    const std::size_t begin = rest.find_first_not_of(kBlanks);
    const std::size_t equal = rest.find('=');
    const std::size_t open = rest.find_first_of("\"'");
    if (begin == rest.npos || equal == rest.npos || open == rest.npos || begin > equal)
      return std::nullopt;
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == rest.npos) return std::nullopt;
    std::string_view found = rest.substr(begin, equal - begin);
    found = found.substr(0, found.find_last_not_of(kBlanks) + 1);
    if (found == name) return withoutReferences(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
  }
}

bool XmlTags::startsWith(std::string_view beginning) const {
  return xml_.substr(at_, beginning.size()) == beginning;
}

void XmlTags::skipBehind(std::string_view end) {
  const std::size_t found = xml_.find(end, at_);
  at_ = found == xml_.npos ? xml_.size() : found + end.size();
}

/// Skips values in quotes, because they may have the character that ends a tag.
std::size_t XmlTags::endOfTag() const {
  std::size_t at = at_;
  for (;;) {
    at = xml_.find_first_of(">\"'", at);
    if (at == xml_.npos) return xml_.size();
    if (xml_[at] == '>') return at;
    at = xml_.find(xml_[at], at + 1);
    if (at == xml_.npos) return xml_.size();
    ++at;
  }
}

}  // namespace link_bounds
