// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// --each: one line per bag, several bags at a time. --merge: one report from files of such lines.
#pragma once

#include <ostream>

#include "tools/bag_bounds/run/bag_bounds_options.h"
#include "tools/bag_bounds/run/bag_question.h"

namespace link_bounds {

/// Writes each line to standard output as soon as its bag is done. Returns the worst exit code,
/// including the lines of --resume. Each bag is read by a process of its own, which starts with a
/// copy of the same memory: a bag cannot influence another one, not even by a crash. Throws
/// std::exception.
int runEach(const BagBoundsOptions& options, BagQuestion& question);

/// Writes one report of the lines in the files `options.bags`. Bags are sorted by name, so that the
/// report depends neither on the order of lines nor on that of files. Returns the worst exit code
/// of the lines. Throws UsageError if files cannot be read, answer different questions, or disagree
/// on a bag.
int writeMerged(const BagBoundsOptions& options, std::ostream& out);

}  // namespace link_bounds
