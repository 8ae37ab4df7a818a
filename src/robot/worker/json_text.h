// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads as much of JSON as the checks of glTF need.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace link_bounds {

/// A value.
struct Json {
  std::string text;  ///< of a string, a number or a word
  bool is_string = false;
  /// Members of an object by name, elements of an array by "0", "1" and so on.
  std::vector<std::pair<std::string, Json>> members;

  /// The member with that name; an empty value if there is none.
  const Json& operator[](std::string_view name) const;
  bool has(std::string_view name) const;
};

/// The first value of a text. Throws MeshError if it does not end, or is nested too deeply.
Json parseJson(std::string_view text);

}  // namespace link_bounds
