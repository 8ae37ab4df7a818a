// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The machine a benchmark runs on.
#pragma once

namespace link_bounds::bench {

/// Keeps this process on one processor.
void pinToOneCpu();

/// The compiler, the processor and the peers, which scripts/figures reads.
void printMachine();

}  // namespace link_bounds::bench
