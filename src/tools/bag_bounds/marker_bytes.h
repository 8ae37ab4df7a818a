// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the bytes of a recorded marker are complete.
#pragma once

#include <cstdint>

namespace link_bounds {

/// Throws ros::serialization::StreamOverrunException if the bytes of a Marker, or of a MarkerArray,
/// end too early. The deserialiser would first take the memory for all that the message announces.
void checkMarkerBytes(const std::uint8_t* data, std::uint32_t size, bool is_array);

}  // namespace link_bounds
