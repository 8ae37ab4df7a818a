// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats names and lists as one line of text.
#pragma once

#include <string>

namespace link_bounds {

inline std::string quoted(const std::string& name) {
  return '"' + name + '"';
}

/// The texts that `to_text` makes of the elements, with `separator` between them; empty texts are
/// not skipped.
template <class Elements, class ToText>
std::string joined(const Elements& elements, const std::string& separator, const ToText& to_text) {
  std::string result;
  bool is_first = true;
  for (const auto& element : elements) {
    result += (is_first ? "" : separator) + to_text(element);
    is_first = false;
  }
  return result;
}

template <class Texts>
std::string joined(const Texts& texts, const std::string& separator) {
  return joined(texts, separator, [](const std::string& text) { return text; });
}

template <class Names>
std::string quotedList(const Names& names) {
  return joined(names, ", ", quoted);
}

}  // namespace link_bounds
