// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times are printed from integers.
#include "tools/bag_bounds/scene/record_time.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

namespace link_bounds {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // ns

}  // namespace

std::string exactSeconds(std::int64_t nanoseconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%s%" PRId64 ".%09" PRId64, nanoseconds < 0 ? "-" : "",
                std::abs(nanoseconds / kSecond), std::abs(nanoseconds % kSecond));
  return text;
}

std::string stampSeconds(std::int64_t stamp) {
  return exactSeconds(toRosTime(stamp) == kStampOfZero ? 0 : stamp);
}

std::string shortSeconds(std::int64_t time, std::int64_t begin) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", static_cast<double>(time - begin) / kSecond);
  return text;
}

}  // namespace link_bounds
