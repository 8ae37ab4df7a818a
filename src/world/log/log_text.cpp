// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Defines the characters that may appear in a log.
#include "world/log/log_text.h"

#include <string_view>

#include "text/utf8.h"

namespace link_bounds {
namespace {

constexpr std::size_t kMaxLength = 600;  // bytes: two long paths, a reason and a remedy

/// False for control characters and for those that break lines or change the writing direction.
bool isPrintable(std::uint32_t code) {
  const auto is_in = [code](std::uint32_t first, std::uint32_t last) {
    return first <= code && code <= last;
  };
  return code >= ' ' && !is_in(0x7f, 0x9f) && !is_in(0x200e, 0x200f) && !is_in(0x2028, 0x202e) &&
         !is_in(0x2066, 0x2069);
}

std::string printable(std::string_view text) {
  return sanitized(text, isPrintable, "?");
}

}  // namespace

std::string logText(const std::string& text) {
  if (text.size() <= kMaxLength) return printable(text);
  const std::string_view all = text;
  return printable(all.substr(0, kMaxLength / 2)) + " ... " +
         printable(all.substr(all.size() - kMaxLength / 2));
}

}  // namespace link_bounds
