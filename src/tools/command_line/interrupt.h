// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C ends a long computation early, and the program prints what it has by then.
#pragma once

#include <functional>

namespace link_bounds {

/// The first SIGINT or SIGTERM sets a flag; a second one of the same kind ends the program.
void catchInterrupts();

/// Whether SIGINT or SIGTERM came. Any thread may call it.
bool isInterrupted();

/// Returns a function that says whether `seconds` have passed since this call, or `is_cancelled`
/// returns true. Any thread may call it.
std::function<bool()> overAfter(double seconds, std::function<bool()> is_cancelled = isInterrupted);

}  // namespace link_bounds
