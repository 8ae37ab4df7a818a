// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// --merge: one report of files of lines.
#pragma once

#include <ostream>

#include "tools/bag_bounds/run/bag_bounds_options.h"

namespace link_bounds {

/// Of the files that `options.bags` names; bags are sorted by name, so that the report depends
/// neither on the order of lines nor on that of files. Returns the worst exit code of the lines.
/// Throws UsageError if files cannot be read, answer different questions, or disagree on a bag.
int writeMerged(const BagBoundsOptions& options, std::ostream& out);

}  // namespace link_bounds
