// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The escapes of each format.
#include "tools/formats/safe_text.h"

#include <cstdio>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

#include "text/utf8.h"

namespace link_bounds {
namespace {

bool isControl(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7f;
}

}  // namespace

std::string validUtf8(const std::string& text) {
  return sanitized(
      text, [](std::uint32_t) { return true; }, "\xef\xbf\xbd");
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

std::string csvField(const std::string& field) {
  const std::string text = validUtf8(field);
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
  out << std::setprecision(std::numeric_limits<double>::max_digits10)
      << value + 0.0;  // turns -0 into 0
  return out.str();
}

std::string shortestNumber(double value) {
  for (int digits = 1; digits < 17; ++digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << value + 0.0;
    std::istringstream in(out.str());
    in.imbue(std::locale::classic());
    double read = 0;
    if (in >> read && read == value) return out.str();
  }
  return exactNumber(value);
}

}  // namespace link_bounds
