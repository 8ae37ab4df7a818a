// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What --each prints of one bag; doc/tools.md has the keys.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/bag_bounds/run/bag_run.h"

namespace link_bounds {

/// By which a bag is recognised.
struct BagIdentity {
  std::string name;                   ///< as it was given
  std::optional<std::uint64_t> size;  ///< [bytes]; none: it cannot be read
  std::string head;                   ///< fingerprint of its first 64 KiB; "" likewise
};

BagIdentity identityOf(const std::string& bag);

/// A line, with its line break.
struct BagLine {
  std::string text;
  int exit_code;
};

/// `question` is BagQuestion::fingerprint(), here and below.
BagLine lineOf(const BagIdentity& bag, const std::string& question, const BagRun& run,
               const Demand& demand);

/// Of a bag about which nothing can be said.
BagLine unusableLine(const BagIdentity& bag, const std::string& question,
                     const std::string& reason);

/// As above; the reason may be another one in a further run.
BagLine diedLine(const BagIdentity& bag, const std::string& question, const std::string& reason);

}  // namespace link_bounds
