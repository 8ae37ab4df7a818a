// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A strict UTF-8 check and the escapes of each format.
#include "tools/text/safe_text.h"

#include <cstdio>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace link_bounds {
namespace {

bool isControl(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7f;
}

/// The length of the well-formed character at `start` (Unicode, table 3-7); 0 if there is none.
std::size_t characterLength(const std::string& text, std::size_t start) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return start + i < text.size() ? static_cast<unsigned char>(text[start + i]) : 0;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  // These leads would else spell overlong forms, surrogates or what lies beyond U+10FFFF.
  const unsigned low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
  const unsigned high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  }
  return length;
}

}  // namespace

std::string validUtf8(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(text, i);
    result += length > 0 ? text.substr(i, length) : "\xef\xbf\xbd";
    i += length > 0 ? length : 1;
  }
  return result;
}

std::string printable(const std::string& text) {
  std::string result = validUtf8(text);
  for (char& c : result) {
    if (isControl(c)) c = ' ';
  }
  return result;
}

std::size_t characterCount(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text)
    count += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return count;
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string jsonString(const std::string& text) {
  std::string result = "\"";
  for (const char c : validUtf8(text)) {
    if (isControl(c)) {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
      result += escape;
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result + "\"";
}

std::string exactNumber(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
  return out.str();
}

}  // namespace link_bounds
