// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A strict decoder: no overlong forms, no surrogates, nothing beyond U+10FFFF (Unicode, 3.9).
#include "text/utf8.h"

#include <array>
#include <optional>

namespace link_bounds {
namespace {

struct Character {
  std::optional<std::uint32_t> code = std::nullopt;  ///< nullopt if the bytes are not well-formed
  std::size_t length = 1;                            ///< bytes
};

/// Decodes the first character. `text` must not be empty.
Character firstCharacter(std::string_view text) {
  // The min code by length in bytes; a smaller code is an overlong form.
  constexpr std::array<std::uint32_t, 5> kMinCode{0, 0, 0x80, 0x800, 0x10000};
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
  if (code < kMinCode[length] || is_surrogate || code > 0x10ffff) return {};
  return {code, length};
}

}  // namespace

std::string sanitized(std::string_view text, bool (*is_allowed)(std::uint32_t code),
                      std::string_view replacement) {
  std::string result;
  while (!text.empty()) {
    const Character character = firstCharacter(text);
    const bool stays = character.code && is_allowed(*character.code);
    result += stays ? text.substr(0, character.length) : replacement;
    text.remove_prefix(character.length);
  }
  return result;
}

}  // namespace link_bounds
