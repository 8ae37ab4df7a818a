// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C ends a long computation early, and the program prints what it has by then.
#pragma once

#include <functional>

namespace link_bounds {

/// From now on the first SIGINT or SIGTERM sets a flag; the second one ends the program.
void catchInterrupts();

/// Whether the signal came. Any thread may call it.
bool isInterrupted();

/// Says whether so many seconds have passed since this call, or `is_cancelled`. Any thread may ask
/// it.
std::function<bool()> overAfter(double seconds, std::function<bool()> is_cancelled = isInterrupted);

}  // namespace link_bounds
