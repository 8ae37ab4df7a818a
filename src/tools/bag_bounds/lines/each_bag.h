// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// --each: a line per bag, several bags at once; --merge: one report of files of lines.
#pragma once

#include <ostream>

#include "tools/bag_bounds/run/bag_bounds_options.h"
#include "tools/bag_bounds/run/bag_question.h"

namespace link_bounds {

/// Writes the lines to standard output as the bags are done. Returns the worst exit code, that of
/// lines of --resume included. Each bag is read by a process of its own, which begins with the same
/// memory: no bag has influence on another one, not even by a crash. Throws std::exception.
int runEach(const BagBoundsOptions& options, BagQuestion& question);

/// Of the files that `options.bags` names; bags are sorted by name, so that the report depends
/// neither on the order of lines nor on that of files. Returns the worst exit code of the lines.
/// Throws UsageError if files cannot be read, answer different questions, or disagree on a bag.
int writeMerged(const BagBoundsOptions& options, std::ostream& out);

}  // namespace link_bounds
