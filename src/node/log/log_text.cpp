// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A strict UTF-8 decoder and what of Unicode a log can bear.
#include "node/log/log_text.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace link_bounds {
namespace {

constexpr std::size_t kLongest = 600;  // bytes: two long paths, a reason and a remedy

struct Character {
  std::uint32_t code = 0;  ///< 0 if the bytes are not well-formed
  std::size_t length = 1;
};

/// Of a text that is not empty.
Character firstCharacter(std::string_view text) {
  constexpr std::array<std::uint32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xc2 || lead > 0xf4) return {};
  const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  if (text.size() < length) return {};
  std::uint32_t code = lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kSmallest[length] || is_surrogate || code > 0x10ffff) return {};
  return {code, length};
}

/// Not for control characters, and not for those that break lines or turn the writing direction.
bool isPrintable(std::uint32_t code) {
  const auto is_in = [code](std::uint32_t first, std::uint32_t last) {
    return first <= code && code <= last;
  };
  return code >= ' ' && !is_in(0x7f, 0x9f) && !is_in(0x200e, 0x200f) && !is_in(0x2028, 0x202e) &&
         !is_in(0x2066, 0x2069);
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character character = firstCharacter(text);
    result += isPrintable(character.code) ? text.substr(0, character.length) : "?";
    text.remove_prefix(character.length);
  }
  return result;
}

}  // namespace

std::string logText(const std::string& text) {
  if (text.size() <= kLongest) return printable(text);
  const std::string_view all = text;
  return printable(all.substr(0, kLongest / 2)) + " ... " +
         printable(all.substr(all.size() - kLongest / 2));
}

}  // namespace link_bounds
