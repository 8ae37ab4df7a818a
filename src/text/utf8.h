// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Replaces bytes in text from outside, such as names, paths and error texts, which may be invalid.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace link_bounds {

/// Replaces each byte that is not part of well-formed UTF-8, and each character for which
/// `is_allowed` returns false, by `replacement`.
std::string sanitized(std::string_view text, bool (*is_allowed)(std::uint32_t code),
                      std::string_view replacement);

}  // namespace link_bounds
