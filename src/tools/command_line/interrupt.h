// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C ends a long computation early, and the program prints what it has by then.
#pragma once

namespace link_bounds {

/// From now on the first SIGINT or SIGTERM sets a flag; the second one ends the program.
void catchInterrupts();

/// Whether the signal came. Any thread may call it.
bool isInterrupted();

}  // namespace link_bounds
