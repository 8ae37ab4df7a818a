// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names and messages from files, made fit for a terminal, a CSV field or a JSON string.
#pragma once

#include <string>

namespace link_bounds {

/// Every byte that is not part of well-formed UTF-8 becomes U+FFFD.
std::string validUtf8(const std::string& text);

/// One line of valid UTF-8: control characters, which could move the cursor, become spaces.
std::string printable(const std::string& text);

/// How many characters of valid UTF-8 there are.
std::size_t characterCount(const std::string& text);

/// As RFC 4180: in quotes if it holds a comma, a quote or a line break.
std::string csvField(const std::string& text);

/// With its quotes.
std::string jsonString(const std::string& text);

/// 17 significant digits, which give back the same double, whatever the locale.
std::string exactNumber(double value);

}  // namespace link_bounds
