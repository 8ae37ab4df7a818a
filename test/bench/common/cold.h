// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Empties the caches of this processor as another program would.
#pragma once

namespace link_bounds::bench {

/// Reads and writes more memory than the last cache holds, and runs more code than the first one
/// holds; so what was there before has to come from memory again.
void emptyCaches();

}  // namespace link_bounds::bench
