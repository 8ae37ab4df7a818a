// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Removes characters from the ends of texts.
#pragma once

#include <optional>
#include <string>

namespace link_bounds {

/// The text without these characters at both ends.
inline std::string trimmed(const std::string& text, const char* characters = " \t\r\n") {
  const std::size_t begin = text.find_first_not_of(characters);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(characters) - begin + 1);
}

/// The text without `end`; nothing if it does not end with it.
inline std::optional<std::string> withoutEnd(const std::string& text, const std::string& end) {
  if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0)
    return std::nullopt;
  return text.substr(0, text.size() - end.size());
}

inline bool endsWith(const std::string& text, const std::string& end) {
  return withoutEnd(text, end).has_value();
}

}  // namespace link_bounds
