// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Escapes for XML, and a file that is renamed when it is whole.
#include "tools/assert_box/test_report.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tools/text/safe_text.h"

namespace link_bounds {
namespace {

/// For an attribute or between tags; line breaks stay, other control characters become spaces.
std::string xmlText(const std::string& text) {
  std::string result;
  for (const char c : validUtf8(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += "&#10;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  // U+FFFE and U+FFFF are valid UTF-8, but no characters of XML.
  for (const char* bad : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) {
    for (std::size_t at = 0; (at = result.find(bad, at)) != std::string::npos;)
      result.replace(at, 3, "\xef\xbf\xbd");
  }
  return result;
}

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

std::string junitXml(const TestReport& report) {
  char seconds[40];
  std::snprintf(seconds, sizeof(seconds), "%.3f", report.seconds);
  const std::string failures = report.failure.empty() ? "0" : "1";
  const std::string suite = xmlText(report.suite);
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"" + suite +
                    "\" tests=\"1\" failures=\"" + failures + "\" errors=\"0\" time=\"" + seconds +
                    "\">\n  <testcase classname=\"" + suite + "\" name=\"" + xmlText(report.test) +
                    "\" status=\"run\" time=\"" + seconds + "\">\n";
  if (!report.failure.empty()) {
    xml += "    <failure type=\"\" message=\"" + xmlText(firstLine(report.failure)) + "\">" +
           xmlText(report.failure) + "</failure>\n";
  }
  return xml + "  </testcase>\n</testsuite>\n";
}

void writeFile(const std::string& path, const std::string& text) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  const std::string unfinished = path + "." + std::to_string(getpid());
  std::ofstream file(unfinished, std::ios::binary);
  file << text;
  file.close();
  if (file && std::rename(unfinished.c_str(), path.c_str()) == 0) return;
  std::remove(unfinished.c_str());
  throw std::runtime_error("cannot write " + path);
}

}  // namespace link_bounds
