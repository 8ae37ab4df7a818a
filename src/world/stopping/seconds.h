// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Stamps in seconds.
#pragma once

namespace link_bounds {

constexpr double kSecond = 1e9;          // ns
constexpr double kStampRounding = 1e-9;  // s, of the difference of two stamps

}  // namespace link_bounds
