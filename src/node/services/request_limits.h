// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How large requests of services may be, how long answers may take, and what is said if one is
// refused.
#pragma once

#include <chrono>
#include <cstddef>

namespace link_bounds {

/// From the arrival of a request.
constexpr std::chrono::seconds kDeadline(10);

/// A request that takes longer makes way for the next one after so long. A turn of roscpp costs
/// some microseconds.
constexpr std::chrono::milliseconds kLongestTurn(5);

/// As sent. In memory a request takes several times its bytes, because each name is a string.
constexpr std::size_t kMaxRequestBytes = 32 << 20;

constexpr const char* kStopping = "the node is shutting down";
constexpr const char* kTooBusy =
    "there was no time to begin within 10 s, because of other requests or much tf; ask again";

}  // namespace link_bounds
