// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names and messages from files, escaped for a terminal, a CSV field or a JSON string.
#pragma once

#include <string>

namespace link_bounds {

/// Every byte that is not part of well-formed UTF-8 becomes U+FFFD.
std::string validUtf8(const std::string& text);

/// One line of valid UTF-8. Control characters could move the cursor and become spaces.
std::string printable(const std::string& text);

/// The number of characters in valid UTF-8.
std::size_t characterCount(const std::string& text);

/// By RFC 4180, in valid UTF-8: in quotes if it contains a comma, a quote or a line break.
std::string csvField(const std::string& field);

/// A JSON string with its quotes.
std::string jsonString(const std::string& text);

/// 17 significant digits, from which the same double is read back; with a point in every locale.
std::string exactNumber(double value);

/// The fewest digits from which the same double is read back; with a point in every locale.
std::string shortestNumber(double value);

}  // namespace link_bounds
