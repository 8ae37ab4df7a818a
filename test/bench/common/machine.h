// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The machine a benchmark runs on.
#pragma once

#include <string>

namespace link_bounds::bench {

/// Keeps this process on one processor.
void pinToOneCpu();

std::string cpuName();

}  // namespace link_bounds::bench
