// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How many messages may wait for one subscriber; OutputTopic::kMaxBytes bounds their bytes.
#pragma once

#include <cstdint>

namespace link_bounds {

/// Long enough for a subscriber on a busy machine.
constexpr std::uint32_t kBoxesQueue = 200;
constexpr std::uint32_t kMarkersQueue = 10;
constexpr std::uint32_t kFootprintQueue = 10;

}  // namespace link_bounds
