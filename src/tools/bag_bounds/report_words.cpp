// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times are printed from integers.
#include "tools/bag_bounds/report_words.h"

#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace link_bounds {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // ns
constexpr std::array<const char*, 3> kLevels{"BOX", "HULL", "MESH"};

}  // namespace

std::string exactSeconds(std::int64_t nanoseconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%s%" PRId64 ".%09" PRId64, nanoseconds < 0 ? "-" : "",
                std::abs(nanoseconds / kSecond), std::abs(nanoseconds % kSecond));
  return text;
}

std::string shortSeconds(std::int64_t time, std::int64_t begin) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", static_cast<double>(time - begin) / kSecond);
  return text;
}

const char* toText(StayEnd end) {
  switch (end) {
    case StayEnd::kLeft:
      return "left";
    case StayEnd::kLost:
      return "lost";
    case StayEnd::kReportEnded:
      break;
  }
  return "report_ended";
}

const char* levelText(std::uint8_t level) {
  return kLevels.at(level);
}

}  // namespace link_bounds
