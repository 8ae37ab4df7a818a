// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Times and ends of stays, in words and digits.
#pragma once

#include <cstdint>
#include <string>

#include "tools/bag_bounds/zone_watch.h"

namespace link_bounds {

/// Nanoseconds as seconds, from integers, so that none is lost.
std::string exactSeconds(std::int64_t nanoseconds);

/// Seconds from `begin` to `time` [ns] for people.
std::string shortSeconds(std::int64_t time, std::int64_t begin);

const char* toText(StayEnd end);

}  // namespace link_bounds
